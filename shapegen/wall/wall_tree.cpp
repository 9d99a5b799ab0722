// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/wall/wall_tree.hpp"

#include <algorithm>
#include <utility>

namespace dem::shapegen {

namespace {

class TreeBuilder {
  public:
    TreeBuilder(std::span<const Vec3> points, std::span<const WallMesh::Triangle> triangles) {
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            Entry entry{{}, t};
            for (const std::uint32_t corner : triangles[t]) entry.box.extend(points[corner]);
            entries_.push_back(entry);
        }
        build(0, static_cast<std::uint32_t>(entries_.size()));
    }

    std::vector<WallMesh::Box> boxes() { return std::move(boxes_); }
    std::uint32_t triangle(std::size_t place) const { return entries_[place].triangle; }

  private:
    struct Entry {
        Aabb box;
        std::uint32_t triangle;

        double middle(Eigen::Index axis) const { return box.lower[axis] + box.upper[axis]; }
    };

    void build(std::uint32_t first, std::uint32_t last) {
        Aabb box;
        Aabb middles;
        for (std::uint32_t k = first; k < last; ++k) {
            box.extend(entries_[k].box);
            middles.extend(entries_[k].box.lower + entries_[k].box.upper);
        }
        const std::size_t here = boxes_.size();
        const std::uint32_t count = last - first;
        const bool is_leaf = count <= WallMesh::leaf_size;
        boxes_.push_back({box.lower, box.upper, first, is_leaf ? count : 0, 0});
        if (!is_leaf) {
            Eigen::Index axis = 0;
            (middles.upper - middles.lower).maxCoeff(&axis);
            std::sort(entries_.begin() + first, entries_.begin() + last,
                      [axis](const Entry& a, const Entry& b) {
                          return std::pair(a.middle(axis), a.triangle) <
                                 std::pair(b.middle(axis), b.triangle);
                      });
            const std::uint32_t half = first + count / 2;
            build(first, half);
            build(half, last);
        }
        boxes_[here].next = static_cast<std::uint32_t>(boxes_.size());
    }

    std::vector<Entry> entries_;
    std::vector<WallMesh::Box> boxes_;
};

}  // namespace

std::vector<WallMesh::Box> sort_into_tree(std::span<const Vec3> points,
                                          std::vector<WallMesh::Triangle>& triangles) {
    TreeBuilder builder(points, triangles);
    std::vector<WallMesh::Triangle> sorted;
    sorted.reserve(triangles.size());
    for (std::size_t k = 0; k < triangles.size(); ++k)
        sorted.push_back(triangles[builder.triangle(k)]);
    triangles = std::move(sorted);
    return builder.boxes();
}

}  // namespace dem::shapegen
