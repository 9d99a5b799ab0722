// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem::runtime {

/// A clump against a wall: every sphere that reaches into the wall is a contact point, as a lone
/// sphere would have it (sphere_wall.hpp); spheres whose centers lie beyond the rim of a disc or of
/// the open end of a tube do not touch. The wall's curvature does not enter R*, which is the radius
/// of the deepest sphere.
template <AnyWall Wall>
PairContact collide(const Clump& a, const Wall& wall, const PatchCall& call);

}  // namespace dem::runtime
