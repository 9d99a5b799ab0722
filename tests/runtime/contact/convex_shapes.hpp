// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/contact_types.hpp"

#include <vector>

/// Convex surfaces of revolution built by hand: support maps with crowned flats and what the
/// continuous kernels read, nothing else (no distance field, no nodes).
namespace dem::test {

using namespace runtime;

struct SolidBody {
    SrShape shape;
    double volume = 0.0;            ///< [m^3]
    Vec3 moments_per_density = {};  ///< [m^5]
    InverseInertia inverse(double density) const;
};

SolidBody spheroid(double a, double c);
inline SolidBody candy() {
    return spheroid(6.585e-3, 3.395e-3);
}
/// Bi-convex tablet with sharp edges: radius and height of its band, height of a cap [m].
SolidBody tablet(double band_radius, double band_height, double cap_height);
/// Of [SR] Table 1.
inline SolidBody tablet() {
    return tablet(5.675e-3, 4.0e-3, 1.23e-3);
}
/// The polygon of these corners (r, z) [m], the lowest first, revolved: each side a crowned flat,
/// each corner sharp. Off the axis the ends are closed by discs. Must be convex.
SolidBody revolved(const std::vector<Vec2>& corners);
inline SolidBody cylinder(double radius, double height) {
    return revolved({{radius, -0.5 * height}, {radius, 0.5 * height}});
}
inline SolidBody frustum(double lower_radius, double upper_radius, double height) {
    return revolved({{lower_radius, 0.0}, {upper_radius, height}});
}
/// A sphere as a surface of revolution.
inline SolidBody round_body(double radius) {
    return spheroid(radius, radius);
}

/// Support map of pieces in rising direction, each holding directions up to `piece_end`.
SupportMap support_map(std::vector<SupportPiece> pieces, std::vector<double> piece_end);

}  // namespace dem::test
