// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem::runtime {

/// The nodes of a surface of revolution against a wall [SR] Sec. 2.4: for non-convex shapes, for
/// walls without a smooth kernel (sr_wall.hpp) and for `contact = nodes`. Nodes beyond the rim of a
/// disc or of the open end of a tube do not touch. The wall's curvature does not enter R*.
template <AnyWall Wall>
PairContact collide(const SrShape& a, const Wall& wall, const PatchCall& call);

}  // namespace dem::runtime
