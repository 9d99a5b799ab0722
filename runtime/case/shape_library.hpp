// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/template_reader.hpp"
#include "runtime/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace dem::runtime {

/// Shapes that the bodies of a case may take: those of a template file, or one sphere. Only what is
/// taken is made and put into the scene.
class ShapeLibrary {
  public:
    /// Throws Error naming the file.
    explicit ShapeLibrary(const std::string& path);
    explicit ShapeLibrary(double radius);

    /// Number of shapes.
    std::size_t size() const { return in_scene_.size(); }
    std::uint64_t input_hash() const { return input_hash_; }

    /// Index of the first shape of this name.
    std::optional<std::size_t> find(const std::string& name);

    /// What a message about a name that was not found ends with: the nearest one, or all.
    std::string suggestion_for(const std::string& name) const;

    /// Places in Scene::shapes of the shapes with these indices, in their order; those that are new
    /// to the scene are appended to it in that order. Throws Error naming file and shape.
    std::vector<std::uint32_t> take(std::span<const std::size_t> indices, Scene& scene);

  private:
    std::string name(std::size_t index) const;
    ParticleTemplate make(std::size_t index) const;

    std::optional<TemplateLibrary> file_;
    double radius_ = 0.0;  ///< of the sphere [m], without a file
    std::uint64_t input_hash_ = 0;
    std::vector<std::uint32_t> in_scene_;  ///< place of each shape in Scene::shapes, or `none`
    std::unordered_map<std::string, std::size_t> by_name_;  ///< filled by the first find()
};

}  // namespace dem::runtime
