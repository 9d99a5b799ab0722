// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/shape_library.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "common/threads/thread_team.hpp"
#include "runtime/case/sphere_template.hpp"
#include "runtime/case/values.hpp"

#include <limits>

namespace dem::runtime {

namespace {

/// Shapes that one thread reads at a time: some 10 us each and more.
constexpr std::size_t shapes_at_a_time = 4;
constexpr std::uint32_t not_there = std::numeric_limits<std::uint32_t>::max();

}  // namespace

ShapeLibrary::ShapeLibrary(const std::string& path)
    : file_(path), input_hash_(file_->head().input_hash), in_scene_(file_->size(), not_there) {}

ShapeLibrary::ShapeLibrary(double radius) : radius_(radius), in_scene_(1, not_there) {}

std::string ShapeLibrary::name(std::size_t index) const {
    return file_ ? file_->name(index) : std::string("sphere");
}

ParticleTemplate ShapeLibrary::make(std::size_t index) const {
    return file_ ? file_->shape(index) : sphere_template(radius_);
}

std::optional<std::size_t> ShapeLibrary::find(const std::string& name) {
    if (by_name_.empty())
        for (std::size_t k = 0; k < size(); ++k) by_name_.emplace(this->name(k), k);
    const auto entry = by_name_.find(name);
    if (entry == by_name_.end()) return std::nullopt;
    return entry->second;
}

std::string ShapeLibrary::suggestion_for(const std::string& name) const {
    std::vector<std::string> known;
    for (std::size_t k = 0; k < size(); ++k) known.push_back(this->name(k));
    return suggestion_or_all(name, known);
}

std::vector<std::uint32_t> ShapeLibrary::take(std::span<const std::size_t> indices, Scene& scene) {
    const std::size_t first = scene.shapes.size();
    std::vector<std::size_t> fresh;
    for (const std::size_t index : indices) {
        if (in_scene_[index] != not_there) continue;
        in_scene_[index] = static_cast<std::uint32_t>(first + fresh.size());
        fresh.push_back(index);
    }
    scene.shapes.resize(first + fresh.size());
    share_each(fresh.size(), shapes_at_a_time,
               [&](std::size_t k) { scene.shapes[first + k] = make(fresh[k]); });
    std::vector<std::uint32_t> places;
    places.reserve(indices.size());
    for (const std::size_t index : indices) places.push_back(in_scene_[index]);
    return places;
}

}  // namespace dem::runtime
