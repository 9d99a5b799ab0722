// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem {

/// Convex shapes against walls (wall_shapes.hpp): every near vertex and rim as a feature. The
/// wall's curvature does not enter R*. A solid rod is a convex shape of its own.
PairContact collide(const ConvexShape& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory);
PairContact collide(const ConvexShape& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory);

/// Walls without a kernel of their own, by their distance fields (convex_in_field.hpp).
template <AnyWall Wall>
PairContact collide(const ConvexShape& a, const Wall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory);

}  // namespace dem
