// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Thin names for the fixed-size double types of Eigen. SI units unless a name says otherwise.
namespace dem {

using Vec2 = Eigen::Vector2d;  ///< (r, z) in the half plane of a surface of revolution
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Orientation, body -> world. Unaligned so that structs holding one can be copied byte by byte.
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

/// World direction of body z: the axis of a surface of revolution, of a cylinder, a plane's normal.
inline Vec3 body_axis(const Quat& q) {
    return {2.0 * (q.x() * q.z() + q.w() * q.y()), 2.0 * (q.y() * q.z() - q.w() * q.x()),
            1.0 - 2.0 * (q.x() * q.x() + q.y() * q.y())};
}

/// The smallest rotation that takes body z to a direction of any length but zero. (Eigen's own
/// costs every file that calls it ten seconds to compile.)
inline Quat orientation_towards(const Vec3& direction) {
    const Vec3 d = direction.normalized();
    const double across2 = d.x() * d.x() + d.y() * d.y();
    if (across2 == 0.0 && d.z() < 0.0) return {0.0, 1.0, 0.0, 0.0};
    // 1 + d.z, without losing digits where d points down.
    const double w = d.z() < 0.0 ? across2 / (1.0 - d.z()) : 1.0 + d.z();
    const double scale = 1.0 / std::sqrt(w * w + across2);
    return {scale * w, -scale * d.y(), scale * d.x(), 0.0};
}

/// A Vec3 in memory that is copied, stored and sent byte by byte (Eigen's own is not trivially
/// copyable).
struct StoredVec3 {
    double x = 0.0, y = 0.0, z = 0.0;

    StoredVec3() = default;
    StoredVec3(const Vec3& v)
        : x(v.x()), y(v.y()), z(v.z()) {}        // NOLINT(google-explicit-constructor)
    operator Vec3() const { return {x, y, z}; }  // NOLINT(google-explicit-constructor)
};

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinite = std::numeric_limits<double>::infinity();

inline constexpr double square(double x) {
    return x * x;
}
inline constexpr double cube(double x) {
    return x * x * x;
}

}  // namespace dem
