// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/motion.hpp"

#include <algorithm>
#include <cmath>

/// The normal force of the Hertz-Mindlin law [SR] Eqs. 10-15 and of the linear one [GC] Sec. 6, and
/// the coefficients of all springs and dashpots of a contact (docs/contact.md, "Force law").
///   k_n = 4/3 Y* sqrt(R* d), gamma_n = sqrt(5) |beta| sqrt(m_e k_n), F_n = k_n d + gamma_n d'
/// d overlap, m_e effective mass of the contact.
namespace dem::runtime {

/// Energy of a spring over force times overlap.
inline double elastic_share(const ContactLaw& law) {
    return law.model == ContactLaw::Model::linear ? 0.5 : 0.4;
}

struct ContactCoefficients {
    double k_n;      ///< [N/m]
    double gamma_n;  ///< [kg/s]
    double k_t, gamma_t;
    double frequency;  ///< sqrt(k_n/m_e) [rad/s]
};

/// Linear spring-dashpot [GC] Eqs. 13-16, corrected: k_t = k_n (1/mu)/B (pi^2 + ln^2 e_t)/(pi^2 +
/// ln^2 e_n), gamma_t = -(2/t_c) ln e_t / B.
inline ContactCoefficients linear_coefficients(const ContactLaw& law, double inverse_mass,
                                               const TangentialInertia& tangential) {
    ContactCoefficients c{};
    c.k_n = law.normal_stiffness;
    c.frequency = std::sqrt(c.k_n * inverse_mass);
    c.gamma_n = inverse_mass > 0.0 ? law.damping * c.frequency / inverse_mass : 0.0;
    if (!(tangential.inverse > 0.0)) return c;
    c.k_t = c.k_n * law.tangential_stiffness * tangential.inverse_reduced / tangential.inverse;
    c.gamma_t =
        law.tangential_damping * std::sqrt(c.k_n * tangential.inverse_reduced) / tangential.inverse;
    return c;
}

/// `inverse_mass` = 1/m_e [1/kg].
inline ContactCoefficients contact_coefficients(const ContactLaw& law, double radius,
                                                double overlap, double inverse_mass,
                                                const TangentialInertia& tangential) {
    if (law.model == ContactLaw::Model::linear)
        return linear_coefficients(law, inverse_mass, tangential);
    const double root = std::sqrt(radius * overlap);
    ContactCoefficients c{};
    c.k_n = 4.0 / 3.0 * law.youngs_modulus * root;
    c.frequency = std::sqrt(c.k_n * inverse_mass);
    const double mass = inverse_mass > 0.0 ? 1.0 / inverse_mass : 0.0;
    c.gamma_n = law.damping * c.frequency * mass;
    c.k_t = law.tangential == ContactLaw::Tangential::mindlin ? 8.0 * law.shear_modulus * root
                                                              : law.stiffness_ratio * c.k_n;
    c.gamma_t = law.damping_ratio * c.gamma_n;
    return c;
}

/// How long the normal dashpot acts in this step, in steps. A linear one sets in with its full
/// force at the touch and stops at the parting: where one of them is less than a step away it acts
/// from half a step before to half a step after now, but not beyond. Without this a restitution of
/// 0.3 is off by up to 0.01 at t_c/50. Hertz's dashpot sets in from zero.
inline double dashpot_share(const ContactLaw& law, const ContactCoefficients& c, double overlap,
                            double rate, double dt) {
    if (law.model != ContactLaw::Model::linear) return 1.0;
    if (rate > 0.0) return overlap < rate * dt ? 0.5 + overlap / (rate * dt) : 1.0;
    // Until the next step the bodies part at the rate that this step's forces leave. A longer pull
    // must not keep them together for a step that it has counted already.
    const double push = -rate + 0.5 * dt * square(c.frequency) * overlap;
    const double pull = -0.5 * dt * c.frequency * law.damping * rate;
    const double path = (push - pull) * dt;
    if (!(overlap < path && pull > 0.0)) return 1.0;
    return std::min(0.5 + overlap / path, 0.5 + 0.5 * (push - overlap / dt) / pull);
}

/// How a point, or one of many that share an overlap by weights, is pressed.
struct Pressing {
    double overlap;       ///< of the contact [m]
    double rate;          ///< of the overlap at the point [m/s]
    double weight = 1.0;  ///< of the point in the overlap; < 0 where it counts against others
};

struct NormalForce {
    double elastic_part;  ///< [N]
    double size;          ///< along the gradient of the overlap, > 0 repulsive [N]
    double dissipated;    ///< in this step [J]
};

/// Spring and dashpot along the normal.
inline NormalForce normal_force(const ContactLaw& law, const ContactCoefficients& c,
                                const Pressing& point, double dt) {
    NormalForce f{};
    f.elastic_part = point.weight * c.k_n * point.overlap;
    const double share = dashpot_share(law, c, point.overlap, point.rate, dt);
    f.size = f.elastic_part + share * point.weight * c.gamma_n * point.rate;
    if (law.limit_force && point.weight > 0.0) f.size = std::max(f.size, 0.0);
    f.dissipated = (f.size - f.elastic_part) * point.rate * dt;
    return f;
}

/// The normal force of which friction may be the share mu [N]: the elastic part of it. The dashpot
/// gives no impulse over a whole contact, but it pulls at its end; friction cut at the size of the
/// damped force would go on there, and sliding impacts would exceed Coulomb. Where the damped force
/// is itself cut at zero it serves: what the dashpot then gives does not vanish.
inline double friction_load(const ContactLaw& law, double elastic_part, double force) {
    return law.limit_force ? force : elastic_part;
}

}  // namespace dem::runtime
