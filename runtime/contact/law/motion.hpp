// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
inline double inverse_reduced_mass(const PairState& pair) {
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
struct TangentialInertia {
    double inverse_reduced = 0.0;  ///< 1/mu of the two masses [1/kg]
    double inverse = 0.0;  ///< B: 1/mu and the mean squared surface distances over moments [1/kg]
};
inline TangentialInertia tangential_inertia(const PairState& pair) {
    const InverseInertia& i = pair.i.inverse_inertia;
    const InverseInertia& j = pair.j.inverse_inertia;
    const double reduced = i.mass + j.mass;
    return {reduced, reduced + i.surface + j.surface};
}

/// Velocity of i relative to j at a point of lever r_i from the center of i [m/s].
inline Vec3 relative_velocity(const PairState& pair, const Vec3& r_i) {
    return pair.i.velocity - pair.j.velocity + pair.i.angular_velocity.cross(r_i) -
           pair.j.angular_velocity.cross(r_i - pair.displacement);
}

/// Mean angular velocity of the bodies about a normal, with which a contact turns [rad/s].
inline double spin_about(const PairState& pair, const Vec3& normal) {
    return 0.5 * normal.dot(pair.i.angular_velocity + pair.j.angular_velocity);
}

/// One contact point as the law sees it.
struct PointMotion {
    const PairState& pair;
    Vec3 lever;           ///< of the point from the center of i [m]
    Vec3 normal;          ///< unit, from j towards i
    double overlap;       ///< [m]
    Vec3 velocity;        ///< of i relative to j at the point [m/s]
    double overlap_rate;  ///< > 0 while approaching [m/s]
    double inverse_mass;  ///< 1/m_e [1/kg]
};

/// Motion at a point with a unit normal; the mass is left out.
inline PointMotion motion_at(const PairState& pair, const Vec3& lever, const Vec3& normal,
                             double overlap) {
    const Vec3 velocity = relative_velocity(pair, lever);
    return {pair, lever, normal, overlap, velocity, -velocity.dot(normal), 0.0};
}

}  // namespace dem::runtime
