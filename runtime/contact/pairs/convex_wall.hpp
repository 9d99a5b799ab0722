// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem::runtime {

/// Convex shapes against walls (wall_shapes.hpp): every near vertex and rim as a feature. The
/// wall's curvature does not enter R*. A solid rod is a convex shape of its own.
PairContact collide(const ConvexShape& a, const PlaneWall& wall, const CoreCall& call);
PairContact collide(const ConvexShape& a, const CylinderWall& wall, const CoreCall& call);

/// Walls without a kernel of their own, by their distance fields (convex_in_field.hpp).
template <AnyWall Wall>
PairContact collide(const ConvexShape& a, const Wall& wall, const CoreCall& call);

}  // namespace dem::runtime
