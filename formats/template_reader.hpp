// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_template.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace dem {

namespace schema {
struct TemplateFile;
}
class MemoryMap;

/// A `.tpl` file whose shapes are made and checked when they are asked for: a library may hold a
/// million of which a case takes a hundred.
class TemplateLibrary {
  public:
    /// Maps a file, whose arrays keep the map alive. Its checksum and the structure of all of it
    /// are verified. Throws Error naming the file: missing, a directory, not a template, another
    /// format version, truncated, damaged.
    explicit TemplateLibrary(const std::filesystem::path& path);

    /// Verifies a file whose bytes are in memory, aligned to 8; the arrays share `owner`. `where`
    /// names them in messages. Throws as the other.
    TemplateLibrary(std::shared_ptr<const void> owner, std::span<const std::byte> bytes,
                    std::string where);

    /// Number of shapes, at least one.
    std::size_t size() const;
    std::string name(std::size_t index) const;

    /// A shape with its arrays in the map; nothing of it needs to be checked again. Throws Error
    /// naming file and shape: a value out of range.
    /// Throws for a wall, too.
    ParticleTemplate shape(std::size_t index) const;

    bool is_wall(std::size_t index) const;
    /// The same of a wall. Throws Error for a particle.
    WallTemplate wall(std::size_t index) const;

    /// Everything but the shapes.
    TemplateFile head() const;

  private:
    TemplateLibrary(const std::shared_ptr<const MemoryMap>& map, std::string where);

    std::shared_ptr<const void> owner_;
    std::string where_;
    const schema::TemplateFile* root_;
};

/// All of a file, or of bytes in memory. Throws Error as above.
TemplateFile read_template(const std::filesystem::path& path);
TemplateFile read_template(const std::shared_ptr<const void>& owner,
                           std::span<const std::byte> bytes, const std::string& where);

}  // namespace dem
