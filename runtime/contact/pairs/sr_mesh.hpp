// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/meshes/mesh_history.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/walls/mesh_wall.hpp"

namespace dem::runtime {

template <>
struct SmoothHistory<MeshWall> {
    using Type = MeshHistory;
};

/// A convex surface of revolution against a surface of triangles (docs/mesh-walls.md, "Smooth
/// bodies"). The curvature of the surface does not enter R*.
PairContact collide(const SrShape& a, const MeshWall& wall, const MeshCall& call);

}  // namespace dem::runtime
