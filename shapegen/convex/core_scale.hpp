// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/solids/convex_polyhedron.hpp"

namespace dem::shapegen {

/// The factor by which a core is to be scaled so that the body around it, all within `rounding` [m]
/// of it, has the volume wanted [m^3]. Throws Error where the rounding alone has more.
double core_scale(const ConvexPolyhedron& core, double rounding, double volume);

}  // namespace dem::shapegen
