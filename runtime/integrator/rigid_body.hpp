// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/lanes.hpp"
#include "common/math/types.hpp"

#include <cmath>

/// Motion of one rigid body, pure functions (docs/time-integration.md). The angular momentum L is
/// carried in the world frame: without torque it does not change by a bit.
namespace dem::runtime {

/// Below this square of half the angle [rad^2] a rotation is its Taylor series: a step turns a body
/// by less.
inline constexpr double small_turn2 = 1e-6;

/// Unit quaternion of the rotation by a small vector `turn` [rad]; `x2`: square of half its length.
/// The next terms are below 1e-19 of the sums.
template <class Real>
QuatOf<Real> small_rotation(const Vec3Of<Real>& turn, const Real& x2) {
    const Real sine_ratio = 1.0 - x2 * (1.0 / 6.0 - x2 * (1.0 / 120.0));  // sin(x)/x
    const Real cosine = 1.0 - x2 * (1.0 / 2.0 - x2 * (1.0 / 24.0));
    const Real s = 0.5 * sine_ratio;
    return {cosine, s * turn.x(), s * turn.y(), s * turn.z()};
}

/// Unit quaternion of the rotation by the vector `turn` [rad].
inline Quat rotation(const Vec3& turn) {
    const double x2 = 0.25 * turn.squaredNorm();
    if (x2 < small_turn2) return small_rotation(turn, x2);
    const double x = std::sqrt(x2);
    const math::SineCosine half = math::sin_cos(x);
    const double s = 0.5 * (half.sine / x);
    return {half.cosine, s * turn.x(), s * turn.y(), s * turn.z()};
}

/// Inverse principal moments of a body of revolution [1/(kg m^2)].
template <class Real>
struct AxialMoments {
    Real across, along;

    MaskOf<Real> are_equal() const { return across == along; }
};

/// Angular velocity of a body of revolution with its axis and angular momentum.
template <class Real>
Vec3Of<Real> angular_velocity_of(const AxialMoments<Real>& m, const Vec3Of<Real>& axis,
                                 const Vec3Of<Real>& L) {
    Vec3Of<Real> across = m.across * L;
    if (all(m.are_equal())) return across;
    return select(m.are_equal(), across,
                  Vec3Of<Real>(across + Real((m.along - m.across) * L.dot(axis)) * axis));
}

/// World angular velocity [rad/s] of a body with orientation q, angular momentum L [kg m^2/s] and
/// inverse principal moments [1/(kg m^2)].
inline Vec3 angular_velocity(const Quat& q, const Vec3& L, const Vec3& inverse_moments) {
    const Vec3& m = inverse_moments;
    if (m.x() == m.y()) return angular_velocity_of<double>({m.x(), m.z()}, body_axis(q), L);
    const Vec3 L_body = q.conjugate() * L;
    return q * Vec3(m.cwiseProduct(L_body));
}

/// Length correction of a quaternion that is a unit one but for rounding.
template <class Real = double>
QuatOf<Real> renormalized(const QuatOf<Real>& q) {
    const Real scale = 1.5 - 0.5 * q.squaredNorm();
    return {scale * q.w(), scale * q.x(), scale * q.y(), scale * q.z()};
}

/// q followed by the rotation `own` about body z.
template <class Real = double>
QuatOf<Real> turned_about_own_axis(const QuatOf<Real>& q, const QuatOf<Real>& own) {
    const Real c = own.w();
    const Real s = own.z();
    return {q.w() * c - q.z() * s, q.x() * c + q.y() * s, q.y() * c - q.x() * s,
            q.z() * c + q.w() * s};
}

/// Orientation of a body of revolution after its precession by `turn` [rad] and its own spin by
/// `own` [rad]; `rotate`: unit quaternions of such vectors.
template <class Real, class Rotate>
QuatOf<Real> precessed(const AxialMoments<Real>& m, const QuatOf<Real>& q, const Vec3Of<Real>& L,
                       double dt, const Rotate& rotate) {
    const QuatOf<Real> precession = rotate(Vec3Of<Real>(Real(dt * m.across) * L));
    if (all(m.are_equal())) return renormalized<Real>(precession * q);
    const Real own_spin = (m.along - m.across) * L.dot(body_axis(q));
    const QuatOf<Real> own = rotate(Vec3Of<Real>{Real{}, Real{}, Real(dt * own_spin)});
    return renormalized<Real>(precession *
                              select(m.are_equal(), q, turned_about_own_axis<Real>(q, own)));
}

/// Orientation after free motion with constant L over dt [s].
/// A sphere turns about L. A body of revolution turns exactly about L at L/I_x and about its own
/// axis with the rest of its spin: the closed form of the symmetric top, right for any dt. Three
/// different moments: the exact rotation of the angular velocity at the midpoint, which is found by
/// iteration, so that the step is symmetric in time and the energy does not drift.
inline Quat rotated(const Quat& q, const Vec3& L, const Vec3& inverse_moments, double dt) {
    const Vec3& m = inverse_moments;
    if (m.x() == m.y()) return precessed<double>({m.x(), m.z()}, q, L, dt, rotation);
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
