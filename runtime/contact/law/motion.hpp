// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/lanes.hpp"
#include "runtime/contact/contact_types.hpp"

/// How two bodies move at a contact, and what of their masses resists there.
namespace dem::runtime {

/// a . I^-1 a of a body for a world vector a. Bodies of revolution need only their axis.
inline double inverse_inertia_along(const BodyState& body, const Vec3& a) {
    const Vec3& inverse = body.inverse_inertia.moments;
    const Quat& q = body.orientation;
    if (inverse.x() == inverse.y()) {
        if (inverse.x() == inverse.z()) return inverse.x() * a.squaredNorm();
        const double along = a.dot(body_axis(q));
        return inverse.x() * a.squaredNorm() + (inverse.z() - inverse.x()) * (along * along);
    }
    const Vec3 a_body = q.conjugate() * a;
    return inverse.dot(a_body.cwiseProduct(a_body));
}

/// 1/m* of two bodies moving without turning [1/kg].
template <class Pair>
typename Pair::Real inverse_reduced_mass(const Pair& pair) {
    return pair.i.inverse_inertia.mass + pair.j.inverse_inertia.mass;
}

/// 1/m_e along a generalized direction: force `g` on i and -g on j with torques `t_i`, -`t_j`
/// (docs/contact.md, "Damping mass").
inline double inverse_contact_mass(const PairState& pair, const Vec3& g, const Vec3& t_i,
                                   const Vec3& t_j) {
    return g.squaredNorm() * inverse_reduced_mass(pair) + inverse_inertia_along(pair.i, t_i) +
           inverse_inertia_along(pair.j, t_j);
}

/// What resists a tangential motion of a pair at its surfaces, [GC] Sec. 6.
template <class Real>
struct TangentialInertiaOf {
    Real inverse_reduced;  ///< 1/mu of the two masses [1/kg]
    Real inverse;          ///< B: 1/mu and the mean squared surface distances over moments [1/kg]
};
template <class Pair>
TangentialInertiaOf<typename Pair::Real> tangential_inertia(const Pair& pair) {
    const auto& i = pair.i.inverse_inertia;
    const auto& j = pair.j.inverse_inertia;
    const typename Pair::Real reduced = i.mass + j.mass;
    return {reduced, reduced + i.surface + j.surface};
}

template <class Pair>
using Vec3In = Vec3Of<typename Pair::Real>;

/// Velocity of i relative to j at a point of lever r_i from the center of i [m/s].
template <class Pair>
Vec3In<Pair> relative_velocity(const Pair& pair, const Vec3In<Pair>& r_i) {
    return pair.i.velocity - pair.j.velocity + pair.i.angular_velocity.cross(r_i) -
           pair.j.angular_velocity.cross(r_i - pair.displacement);
}

/// Mean angular velocity of the bodies about a normal, with which a contact turns [rad/s].
template <class Pair>
typename Pair::Real spin_about(const Pair& pair, const Vec3In<Pair>& normal) {
    return 0.5 * normal.dot(pair.i.angular_velocity + pair.j.angular_velocity);
}

/// One contact point as the law sees it.
template <class Pair>
struct PointMotionOf {
    using Real = typename Pair::Real;
    const Pair& pair;
    Vec3Of<Real> lever;     ///< of the point from the center of i [m]
    Vec3Of<Real> normal;    ///< unit, from j towards i
    Real overlap;           ///< [m]
    Vec3Of<Real> velocity;  ///< of i relative to j at the point [m/s]
    Real overlap_rate;      ///< > 0 while approaching [m/s]
    Real inverse_mass;      ///< 1/m_e [1/kg]
};
using PointMotion = PointMotionOf<PairState>;

/// Motion at a point with a unit normal; the mass is left out.
template <class Pair>
PointMotionOf<Pair> motion_at(const Pair& pair, const Vec3In<Pair>& lever,
                              const Vec3In<Pair>& normal, const typename Pair::Real& overlap) {
    const Vec3In<Pair> velocity = relative_velocity(pair, lever);
    return {pair, lever, normal, overlap, velocity, -velocity.dot(normal), typename Pair::Real{}};
}

}  // namespace dem::runtime
