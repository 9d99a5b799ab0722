// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/contact_types.hpp"

/// Convex surfaces of revolution built by hand: support maps with crowned flats and what the
/// continuous kernels read, nothing else (no distance field, no nodes).
namespace dem::test {

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
/// Bi-convex tablet of [SR] Table 1: band radius 5.675, band height 4, cap height 1.23 mm.
SolidBody tablet();
SolidBody cylinder(double radius, double height);
/// A sphere as a surface of revolution.
inline SolidBody round_body(double radius) {
    return spheroid(radius, radius);
}

/// Support map of pieces in rising direction, each holding directions up to `piece_end`.
SupportMap support_map(std::vector<SupportPiece> pieces, std::vector<double> piece_end);

}  // namespace dem::test
