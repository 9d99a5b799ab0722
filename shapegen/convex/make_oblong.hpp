// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/solids/make_convex.hpp"

namespace dem::shapegen {

/// An oblong tablet (caplet): a round tablet, its band and its two caps, moved along x. Seen from
/// above it is a stadium: two half circles joined by straight lines.
struct OblongTablet {
    double length = 0.0;       ///< along x [m]
    double width = 0.0;        ///< along y, the diameter of the round tablet, below the length [m]
    double band_height = 0.0;  ///< along z [m]
    double cap_height = 0.0;   ///< of each cap, half the width at most [m]; 0: flat faces
    int sides = 16;            ///< facets that stand for a half circle, 4 or more
};

/// Volume of the smooth tablet with sharp edges, in closed form [m^3].
double volume(const OblongTablet& tablet);

/// The polyhedron that stands for an oblong tablet, rounded. Its facets follow the half circles by
/// `sides` and the caps as closely; heights are those of the tablet, and length and width are
/// stretched together (by 1.5e-3 for 16 sides) so that the sharp polyhedron has the volume of the
/// smooth tablet. Centered at the origin. Throws Error for a rounding that leaves no core.
ConvexSolid make_oblong(const OblongTablet& tablet, double rounding);

/// The largest distance of the smooth tablet's surface from the sharp polyhedron [m], by samples.
double facet_error(const OblongTablet& tablet);

}  // namespace dem::shapegen
