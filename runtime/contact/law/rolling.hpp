// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/slipping_spring.hpp"
#include "runtime/contact/law/whole_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Resistance to rolling, Ai et al. (2011) (docs/contact.md, "Rolling resistance"): a moment
/// against the relative rotation omega_r of the two surfaces across the normal,
///   M = -k_r theta - eta_r omega_r, |M| <= mu_r R* F_n,    eta_r = 2 zeta_r sqrt(I_r k_r)
/// theta rolling angle, a spring that slips; F_n elastic normal force; I_r reduced moment of
/// inertia about the contact.
namespace dem {

struct RollingResistance {
    /// Which k_r: 2.25 k_n mu_r^2 R*^2 (their type C), which a body may swing on before it rolls;
    /// or k_n R*^2, which makes the moment constant but for the first mu_r d of rolling (type A).
    enum class Model : std::uint8_t { elastic_plastic, constant };
    Model model = Model::elastic_plastic;
    double friction = 0.0;  ///< mu_r; 0: no resistance
    double damping = 0.0;   ///< zeta_r, of the swinging, over the critical one
};

struct RollingHistory {
    StoredVec3 angle;        ///< half a step ahead [rad]
    double stiffness = 0.0;  ///< k_r of the step before [N m]
};

/// What one body gives way to a rotation about `axis` (unit) on the other: 1/(I + m l^2), l its
/// lever [1/(kg m^2)].
inline double inverse_rolling_inertia(const BodyState& body, double lever2, const Vec3& axis) {
    const double inverse_mass = body.inverse_inertia.mass;
    if (!(inverse_mass > 0.0)) return 0.0;
    const double inverse = inverse_inertia_along(body, axis);
    return inverse / (1.0 + inverse * lever2 / inverse_mass);
}

/// Moment on i [N m]; -moment acts on j.
inline Vec3 rolling_moment(const RollingResistance& law, const WholeContact& contact,
                           RollingHistory& history, ContactEnergy& energy) {
    const PairState& pair = contact.pair;
    const Vec3& n = contact.normal;
    const Vec3 turning = pair.i.angular_velocity - pair.j.angular_velocity;
    const Vec3 rate = turning - turning.dot(n) * n;
    Vec3 angle = Vec3::Zero();
    if (!contact.is_new)
        angle = carried(history.angle, contact.last_normal, n, spin_about(pair, n) * contact.dt);
    const Vec3 ahead = angle + contact.dt * rate;
    const double ahead2 = ahead.squaredNorm();
    if (!(ahead2 > 0.0)) {
        history = {};
        return Vec3::Zero();
    }
    const Vec3 axis = ahead / std::sqrt(ahead2);
    const double inverse_inertia =
        inverse_rolling_inertia(pair.i, contact.center.squaredNorm(), axis) +
        inverse_rolling_inertia(pair.j, (contact.center - pair.displacement).squaredNorm(), axis);
    const double softening =
        law.model == RollingResistance::Model::constant ? 1.0 : 2.25 * square(law.friction);
    // Flat bodies have a large R*: no stiffer than a step can follow.
    constexpr double largest_phase = 0.1;
    const double k = std::min(softening * contact.stiffness * square(contact.radius),
                              square(largest_phase / contact.dt) / inverse_inertia);
    const SlippingSpring spring{k, 2.0 * law.damping * std::sqrt(k / inverse_inertia),
                                law.friction * contact.radius * contact.load};
    energy.dissipated += restiffen(history.stiffness, k, contact.taken + energy.dissipated, angle);
    const SpringForce f = slipping_force(spring, rate, contact.dt, angle);
    history = {angle, k};
    energy.elastic += f.elastic;
    energy.dissipated += f.dissipated;
    return f.force;
}

}  // namespace dem
