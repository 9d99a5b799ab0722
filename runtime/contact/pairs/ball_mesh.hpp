// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "common/shapes/sphere.hpp"
#include "runtime/contact/meshes/mesh_history.hpp"
#include "runtime/contact/walls/mesh_wall.hpp"

namespace dem::runtime {

/// A sphere against a surface of triangles, which it touches wherever no way along the surface
/// leads nearer to its center (docs/mesh-walls.md). The curvature of the surface does not enter R*.
PairContact collide(const Sphere& a, const MeshWall& wall, const MeshCall& call);

/// A clump: each of its balls touches as a lone sphere does, and the places of all balls in one
/// contact act together. R* is the radius of the deepest ball.
PairContact collide(const Clump& a, const MeshWall& wall, const MeshCall& call);

}  // namespace dem::runtime
