// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

#include <cmath>

namespace dem {

/// A point relative to a wall's origin, in cylinder coordinates about the wall's z axis.
struct AxialPoint {
    double z;     ///< along the axis [m]
    double r;     ///< from the axis [m]
    Vec3 radial;  ///< unit, away from the axis; zero on it
};

inline AxialPoint axial_point(const Vec3& x, const Vec3& axis) {
    const double z = x.dot(axis);
    const Vec3 across = x - z * axis;
    const double r = across.norm();
    return {z, r, r > 0.0 ? Vec3(across / r) : Vec3::Zero()};
}

}  // namespace dem
