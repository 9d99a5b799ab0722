// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/lanes.hpp"
#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <cmath>

/// Where a wall is. The shapes of walls are bodies of revolution about z so far, so that an origin
/// and an axis say it all; one that is not would add its x axis here.
namespace dem::runtime {

/// A point relative to a wall's origin, in cylinder coordinates about the wall's z axis.
template <class Real>
struct AxialPointOf {
    Real z;               ///< along the axis [m]
    Real r;               ///< from the axis [m]
    Vec3Of<Real> radial;  ///< unit, away from the axis; zero on it
};
using AxialPoint = AxialPointOf<double>;

template <class Real = double>
AxialPointOf<Real> axial_point(const Vec3Of<Real>& x, const Vec3Of<Real>& axis) {
    using Vector = Vec3Of<Real>;
    const Real z = x.dot(axis);
    const Vector across = x - z * axis;
    const Real r = across.norm();
    return {z, r, select(r > 0.0, Vector(across / r), Vector(Vector::Zero()))};
}

/// A wall's own frame, as seen from the frame of who asks.
template <class Real>
struct WallFrameOf {
    Vec3Of<Real> origin;  ///< [m]
    Vec3Of<Real> axis;    ///< unit, the wall's z

    AxialPointOf<Real> at(const Vec3Of<Real>& x) const {
        return axial_point<Real>(x - origin, axis);
    }
};
using WallFrame = WallFrameOf<double>;

/// Angle by which the surface of a body of revolution turns from one orientation to another [rad]:
/// a turn about its own axis moves none of it.
inline double axis_tilt(const Quat& before, const Quat& after) {
    const Vec3 axis_before = before * Vec3::UnitZ();
    const Vec3 axis_after = after * Vec3::UnitZ();
    return 2.0 * math::asin(std::min(1.0, 0.5 * (axis_after - axis_before).norm()));
}

}  // namespace dem::runtime
