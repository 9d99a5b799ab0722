// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_mesh.hpp"
#include "runtime/contact/walls/any_wall.hpp"

#include <memory>

namespace dem::runtime {

/// A surface of triangles in the wall's own frame, touched from both sides (docs/mesh-walls.md). It
/// has no field of distances: bodies may touch it in several contacts at a time (contact/meshes).
struct MeshWall {
    static constexpr std::string_view name = "mesh";

    std::shared_ptr<const WallMesh> mesh;

    /// A cylinder around all of it.
    WallExtent extent() const;
    /// Regions may lie on any side of it.
    static bool confines(double /*low*/, double /*high*/) { return false; }
    /// Its rims and the edges that bend by more than 15 degrees.
    WallOutline outline(double low, double high) const;
    /// The other edges where it turns away from a viewer far away in this direction, ends of each.
    std::vector<std::array<Vec3, 2>> silhouette(const Vec3& towards_viewer) const;
    /// Any turn moves its surface.
    static double surface_turn(const Quat& before, const Quat& after);
};

}  // namespace dem::runtime
