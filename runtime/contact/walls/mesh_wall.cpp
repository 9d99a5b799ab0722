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

WallOutline MeshWall::outline(double /*low*/, double /*high*/) const {
    constexpr double shown_bend = 15.0 * pi / 180.0;
    WallOutline outline;
    for (std::uint32_t h = 0; h < mesh->twins.size(); ++h) {
        // Every edge once, by the first of its half edges.
        if (mesh->twins[h] < h || std::abs(mesh->bends[h]) < shown_bend) continue;
        outline.lines.push_back({mesh->corner(h / 3, h % 3), mesh->corner(h / 3, (h + 1) % 3)});
    }
    return outline;
}

double MeshWall::surface_turn(const Quat& before, const Quat& after) {
    const Quat turn = before.conjugate() * after;
    return 2.0 * math::asin(std::min(1.0, turn.vec().norm()));
}

}  // namespace dem::runtime
