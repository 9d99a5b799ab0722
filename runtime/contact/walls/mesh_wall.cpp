// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/walls/mesh_wall.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

WallExtent MeshWall::extent() const {
    WallExtent extent{mesh->bounds.lower.z(), mesh->bounds.upper.z(), 0.0};
    for (const Vec3& v : mesh->vertices)
        extent.radius = std::max(extent.radius, math::hypot(v.x(), v.y()));
    return extent;
}

namespace {

/// Edges that bend by more are shown in any view [rad].
constexpr double shown_bend = 15.0 * pi / 180.0;

/// Calls use(h, ends) for every edge once, by the first of its half edges.
template <class Use>
void for_each_edge(const WallMesh& mesh, const Use& use) {
    for (std::uint32_t h = 0; h < mesh.twins.size(); ++h) {
        if (mesh.twins[h] < h) continue;
        use(h, std::array<Vec3, 2>{mesh.corner(h / 3, h % 3), mesh.corner(h / 3, (h + 1) % 3)});
    }
}

}  // namespace

WallOutline MeshWall::outline(double /*low*/, double /*high*/) const {
    WallOutline outline;
    for_each_edge(*mesh, [&](std::uint32_t h, const std::array<Vec3, 2>& ends) {
        if (std::abs(mesh->bends[h]) >= shown_bend) outline.lines.push_back(ends);
    });
    return outline;
}

std::vector<std::array<Vec3, 2>> MeshWall::silhouette(const Vec3& towards_viewer) const {
    std::vector<std::array<Vec3, 2>> lines;
    for_each_edge(*mesh, [&](std::uint32_t h, const std::array<Vec3, 2>& ends) {
        if (std::abs(mesh->bends[h]) >= shown_bend) return;
        const auto faces_viewer = [&](std::uint32_t half_edge) {
            return mesh->normals[half_edge / 3].dot(towards_viewer) > 0.0;
        };
        if (faces_viewer(h) != faces_viewer(mesh->twins[h])) lines.push_back(ends);
    });
    return lines;
}

double MeshWall::surface_turn(const Quat& before, const Quat& after) {
    const Quat turn = before.conjugate() * after;
    return 2.0 * math::asin(std::min(1.0, turn.vec().norm()));
}

}  // namespace dem::runtime
