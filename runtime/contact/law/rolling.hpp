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
///   M = -k_r theta - eta_r omega_r, |M| <= mu_r R_r F_n,    eta_r = 2 zeta_r sqrt(I_r k_r)
/// theta rolling angle, a spring that slips; F_n elastic normal force; I_r reduced moment of
/// inertia about the contact; R_r rolling radius, 1/(1/l_i + 1/l_j) of the levers from the centers
/// to the contact: R* of two spheres, and of other bodies a size that does not depend on how they
/// are curved where they touch.
namespace dem::runtime {

struct RollingResistance {
    /// Which k_r: 2.25 k_n mu_r^2 R_r^2 (their type C), which a body may swing on before it rolls;
    /// or k_n R_r^2, which makes the moment constant but for the first mu_r d of rolling (type A).
    enum class Model : std::uint8_t { elastic_plastic, constant };
    Model model = Model::elastic_plastic;
    double friction = 0.0;  ///< mu_r; 0: no resistance
    double damping = 0.0;   ///< zeta_r, of the swinging, over the critical one
};

struct RollingHistory {
    StoredVec3 angle;        ///< half a step ahead [rad]
    double stiffness = 0.0;  ///< k_r of the step before [N m]
};

inline double held_energy(const RollingHistory& history) {
    return 0.5 * history.stiffness * Vec3(history.angle).squaredNorm();
}

/// How easily one body turns about an axis in a rolling contact.
struct RollingInertia {
    double inverse_free = 0.0;     ///< 1/I, about its own center [1/(kg m^2)]
    double inverse_rolling = 0.0;  ///< 1/(I + m l^2), l the part of its lever across the axis
    double inverse_lever =
        0.0;  ///< 1 over its lever [1/m]; 0 for walls and fixed bodies, which count as flat
};
inline RollingInertia rolling_inertia(const BodyState& body, const Vec3& lever, const Vec3& axis) {
    const double inverse_mass = body.inverse_inertia.mass;
    if (!(inverse_mass > 0.0)) return {};
    const double inverse = inverse_inertia_along(body, axis);
    const double about = inverse * lever.cross(axis).squaredNorm() / inverse_mass;
    return {inverse, inverse / (1.0 + about), 1.0 / lever.norm()};
}

/// The spring that resists a rotation about an axis.
inline SlippingSpring rolling_spring(const RollingResistance& law, const WholeContact& contact,
                                     const Vec3& axis) {
    const PairState& pair = contact.pair;
    const RollingInertia i = rolling_inertia(pair.i, contact.center, axis);
    const RollingInertia j = rolling_inertia(pair.j, contact.center - pair.displacement, axis);
    const double radius = 1.0 / (i.inverse_lever + j.inverse_lever);
    const double inverse_inertia = i.inverse_rolling + j.inverse_rolling;
    const double softening =
        law.model == RollingResistance::Model::constant ? 1.0 : 2.25 * square(law.friction);
    // No stiffer, and damped no more, than a step can follow.
    constexpr double largest_phase = 0.1;
    constexpr double largest_decay = 0.2;
    const double k = std::min(softening * contact.stiffness * square(radius),
                              square(largest_phase / contact.dt) / inverse_inertia);
    const double gamma = std::min(2.0 * law.damping * std::sqrt(k / inverse_inertia),
                                  largest_decay / contact.dt / (i.inverse_free + j.inverse_free));
    return {k, gamma, law.friction * radius * contact.load};
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
    const SlippingSpring spring = rolling_spring(law, contact, ahead / std::sqrt(ahead2));
    energy.dissipated +=
        restiffen(history.stiffness, spring.k, contact.taken + energy.dissipated, angle);
    const SpringForce f = slipping_force(spring, rate, contact.dt, angle);
    history = {angle, spring.k};
    energy.elastic += f.elastic;
    energy.dissipated += f.dissipated;
    return f.force;
}

}  // namespace dem::runtime
