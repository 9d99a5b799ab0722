// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"

#include <variant>

namespace dem::runtime {

struct BoxRegion {
    Aabb box;
};
struct CylinderRegion {
    Vec3 from, to;  ///< ends of the axis [m]
    double radius;  ///< [m]
};
using Region = std::variant<BoxRegion, CylinderRegion>;

double volume(const Region& region);  ///< [m^3]
Aabb bounds(const Region& region);    ///< [m]

/// Largest n . x over the region, n a unit vector [m].
double support(const Region& region, const Vec3& n);

/// Whether a point is in the region, its surface included. False for one that is no number.
bool contains(const Region& region, const Vec3& x);

}  // namespace dem::runtime
