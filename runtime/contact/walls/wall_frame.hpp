// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <cmath>

/// Where a wall is. The shapes of walls are bodies of revolution about z so far, so that an origin
/// and an axis say it all; one that is not would add its x axis here.
namespace dem::runtime {

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

/// A wall's own frame, as seen from the frame of who asks.
struct WallFrame {
    Vec3 origin;  ///< [m]
    Vec3 axis;    ///< unit, the wall's z

    AxialPoint at(const Vec3& x) const { return axial_point(x - origin, axis); }
};

/// Angle by which the surface of a body of revolution turns from one orientation to another [rad]:
/// a turn about its own axis moves none of it.
inline double axis_tilt(const Quat& before, const Quat& after) {
    const Vec3 axis_before = before * Vec3::UnitZ();
    const Vec3 axis_after = after * Vec3::UnitZ();
    return 2.0 * math::asin(std::min(1.0, 0.5 * (axis_after - axis_before).norm()));
}

}  // namespace dem::runtime
