// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/core_scale.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "common/shapes/convex_moments.hpp"
#include "shapegen/solids/make_convex.hpp"

namespace dem::shapegen {

// By Steiner's formula V(s) = s^3 V + s^2 A r + s M r^2 + 4/3 pi r^3 with the volume V and the area
// A of the core. M, of its edges, is found from the volume of the body around the core as it is.
double core_scale(const ConvexPolyhedron& core, double rounding, double volume) {
    const ConvexMoments sharp = convex_moments(rounded_around(core, 0.0));
    const double ball = 4.0 / 3.0 * pi * cube(rounding);
    if (!(ball < volume))
        throw Error(
            format("found a rounding of %.4g m, which alone has more volume than the %.4g "
                   "m^3 wanted, expected a smaller one",
                   rounding, volume));
    const double slabs = sharp.area * rounding;
    const double at_one = convex_moments(rounded_around(core, rounding)).volume;
    const double edges = at_one - sharp.volume - slabs - ball;
    const auto excess = [&](double s) {
        return ((s * sharp.volume + slabs) * s + edges) * s + ball - volume;
    };
    double s = 2.0;
    while (excess(s) < 0.0) s *= 2.0;
    // Above the root, where the cubic is convex: Newton's method falls towards it.
    for (int k = 0; k < 100; ++k) {
        const double slope = (3.0 * s * sharp.volume + 2.0 * slabs) * s + edges;
        const double next = s - excess(s) / slope;
        if (!(next < s)) break;
        s = next;
    }
    return s;
}

}  // namespace dem::shapegen
