// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/types.hpp"

#include <cmath>

/// Motion of one rigid body, pure functions (docs/time-integration.md). The angular momentum L is
/// carried in the world frame: without torque it does not change by a bit.
namespace dem::runtime {

/// Unit quaternion of the rotation by the vector `turn` [rad].
inline Quat rotation(const Vec3& turn) {
    const double x2 = 0.25 * turn.squaredNorm();  // half angle squared
    double cosine = 0.0;
    double sine_ratio = 0.0;  // sin(x)/x
    if (x2 < 1e-6) {
        // Taylor, next terms below 1e-19 of the sums: a step turns a body by less than this.
        sine_ratio = 1.0 - x2 * (1.0 / 6.0 - x2 * (1.0 / 120.0));
        cosine = 1.0 - x2 * (1.0 / 2.0 - x2 * (1.0 / 24.0));
    } else {
        const double x = std::sqrt(x2);
        const math::SineCosine half = math::sin_cos(x);
        cosine = half.cosine;
        sine_ratio = half.sine / x;
    }
    const double s = 0.5 * sine_ratio;
    return {cosine, s * turn.x(), s * turn.y(), s * turn.z()};
}

/// World angular velocity [rad/s] of a body with orientation q, angular momentum L [kg m^2/s] and
/// inverse principal moments [1/(kg m^2)].
inline Vec3 angular_velocity(const Quat& q, const Vec3& L, const Vec3& inverse_moments) {
    const Vec3& m = inverse_moments;
    if (m.x() == m.y() && m.x() == m.z()) return m.x() * L;
    if (m.x() == m.y()) {
        const Vec3 axis = body_axis(q);
        return m.x() * L + ((m.z() - m.x()) * L.dot(axis)) * axis;
    }
    const Vec3 L_body = q.conjugate() * L;
    return q * Vec3(m.cwiseProduct(L_body));
}

/// Length correction of a quaternion that is a unit one but for rounding.
inline Quat renormalized(const Quat& q) {
    const double scale = 1.5 - 0.5 * q.squaredNorm();
    return {scale * q.w(), scale * q.x(), scale * q.y(), scale * q.z()};
}

/// q followed by a turn [rad] about body z.
inline Quat turned_about_own_axis(const Quat& q, double turn) {
    const Quat own = rotation({0.0, 0.0, turn});
    const double c = own.w();
    const double s = own.z();
    return {q.w() * c - q.z() * s, q.x() * c + q.y() * s, q.y() * c - q.x() * s,
            q.z() * c + q.w() * s};
}

/// Orientation after free motion with constant L over dt [s].
/// A sphere turns about L. A body of revolution turns exactly about L at L/I_x and about its own
/// axis with the rest of its spin: the closed form of the symmetric top, right for any dt. Three
/// different moments: the exact rotation of the angular velocity at the midpoint, which is found by
/// iteration, so that the step is symmetric in time and the energy does not drift.
inline Quat rotated(const Quat& q, const Vec3& L, const Vec3& inverse_moments, double dt) {
    const Vec3& m = inverse_moments;
    if (m.x() == m.y()) {
        const Quat precession = rotation(dt * m.x() * L);
        if (m.x() == m.z()) return renormalized(precession * q);
        const double own_spin = (m.z() - m.x()) * L.dot(body_axis(q));
        return renormalized(precession * turned_about_own_axis(q, dt * own_spin));
    }
    Vec3 omega = angular_velocity(q, L, m);
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Vec3 next = angular_velocity(rotation(0.5 * dt * omega) * q, L, m);
        const bool converged = (next - omega).squaredNorm() <= 1e-30 * next.squaredNorm();
        omega = next;
        if (converged) break;
    }
    return renormalized(rotation(dt * omega) * q);
}

/// Upper bound of |omega| during free motion with constant L, whatever the orientation [rad/s].
inline double largest_spin(const Vec3& L, const Vec3& inverse_moments) {
    return inverse_moments.maxCoeff() * L.norm();
}

/// Kinetic energy of the rotation [J].
inline double rotational_energy(const Vec3& L, const Vec3& omega) {
    return 0.5 * L.dot(omega);
}

}  // namespace dem::runtime
