// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/hertz_mindlin.hpp"

namespace dem {

/// One contact point as the law sees it, for kernels that know more than a ContactPoint says.
struct PointMotion {
    Vec3 normal;          ///< unit, from j towards i
    Vec3 velocity;        ///< of i relative to j at the contact point [m/s]
    double overlap;       ///< [m]
    double overlap_rate;  ///< > 0 while approaching [m/s]
    double inverse_mass;  ///< 1/m_e [1/kg]
    double spin;          ///< mean angular velocity of the bodies about the normal [rad/s]
    hertz::TangentialInertia tangential;
};

/// Velocity of i relative to j at a point of lever r_i from the centre of i [m/s].
inline Vec3 relative_velocity(const PairState& pair, const Vec3& r_i) {
    return pair.i.velocity - pair.j.velocity + pair.i.angular_velocity.cross(r_i) -
           pair.j.angular_velocity.cross(r_i - pair.displacement);
}

/// Motion at a point of lever r_i from the centre of i with a unit normal; the mass is left out.
inline PointMotion motion_at(const PairState& pair, const Vec3& r_i, const Vec3& normal,
                             double overlap) {
    PointMotion m;
    m.normal = normal;
    m.velocity = relative_velocity(pair, r_i);
    m.overlap = overlap;
    m.overlap_rate = -m.velocity.dot(normal);
    m.inverse_mass = 0.0;
    m.tangential = hertz::tangential_inertia(pair);
    m.spin = 0.5 * normal.dot(pair.i.angular_velocity + pair.j.angular_velocity);
    return m;
}

struct PointForce {
    double normal;    ///< > 0 repulsive [N]
    Vec3 tangential;  ///< on i [N]
    double elastic, dissipated;
};

/// Hertz-Mindlin force of one point (hertz_mindlin.hpp), without the levers.
inline PointForce point_force(const PointMotion& point, double local_radius, const ContactLaw& law,
                              double dt, PointHistory& history) {
    const Vec3& n = point.normal;
    const double radius = hertz::effective_radius(law, local_radius, history);
    const hertz::Coefficients c =
        hertz::coefficients(law, radius, point.overlap, point.inverse_mass, point.tangential);
    const double rate = point.overlap_rate;
    const double spring_force = c.k_n * point.overlap;

    const double dashpot = hertz::dashpot_share(law, c, point.overlap, rate, dt) * c.gamma_n * rate;
    PointForce f{spring_force + dashpot, Vec3::Zero(), 0.0, 0.0};
    if (law.limit_force) f.normal = std::max(f.normal, 0.0);
    const double normal_elastic = hertz::elastic_share(law) * spring_force * point.overlap;
    f.elastic = normal_elastic;
    f.dissipated = (f.normal - spring_force) * rate * dt;

    if (law.friction > 0.0) {
        const Vec3 u_t = point.velocity - point.velocity.dot(n) * n;
        Vec3 spring = Vec3::Zero();
        if (history.effective_radius > 0.0)
            spring = hertz::carried(history.spring, history.normal, n, point.spin * dt);
        f.dissipated +=
            hertz::restiffen(history.stiffness, c.k_t, history.dissipated + f.dissipated, spring);
        const double limit = law.friction * hertz::friction_load(law, spring_force, f.normal);
        const hertz::TangentialForce t =
            hertz::tangential_force(c.k_t, c.gamma_t, limit, u_t, dt, spring);
        history.spring = spring;
        history.stiffness = c.k_t;
        f.tangential = t.force;
        f.elastic += t.elastic;
        f.dissipated += t.dissipated;
    }
    history.normal = n;
    history.dissipated += f.dissipated;
    f.dissipated +=
        hertz::age(law, local_radius, radius, c.frequency * dt, normal_elastic, history);
    return f;
}

}  // namespace dem
