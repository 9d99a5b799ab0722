// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/surface/mesh_convexity.hpp"

#include <algorithm>

namespace dem::shapegen {
namespace {

/// An edge of a triangle, and the corner opposite to it.
struct Side {
    std::uint32_t low, high, opposite, triangle;
    bool operator<(const Side& other) const {
        return low != other.low ? low < other.low : high < other.high;
    }
};

}  // namespace

bool is_convex(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& corners = mesh.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
            sides.push_back({low, high, corners[(k + 2) % 3], t});
        }
    }
    std::sort(sides.begin(), sides.end());
    const Aabb box = bounding_box(mesh);
    const double tolerance = 1e-6 * (box.upper - box.lower).norm();
    // A closed mesh has every edge twice.
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const auto& [a, b, c] = mesh.triangles[sides[i].triangle];
        const Vec3& p = mesh.vertices[a];
        const Vec3 normal = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p);
        const double height = (mesh.vertices[sides[i + 1].opposite] - p).dot(normal);
        if (height > tolerance * normal.norm()) return false;
    }
    return true;
}

}  // namespace dem::shapegen
