// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/motion.hpp"

/// The normal force of the Hertz-Mindlin law [SR] Eqs. 10-15 and of the linear one [GC] Sec. 6, and
/// the coefficients of all springs and dashpots of a contact (docs/contact.md, "Force law").
///   k_n = 4/3 Y* sqrt(R* d), gamma_n = sqrt(5) |beta| sqrt(m_e k_n), F_n = k_n d + gamma_n d'
/// d overlap, m_e effective mass of the contact.
namespace dem::runtime {

/// Energy of a spring over force times overlap.
template <class Law>
double elastic_share(const Law& law) {
    return law.model == ContactLaw::Model::linear ? 0.5 : 0.4;
}

template <class Real>
struct ContactCoefficientsOf {
    Real k_n;      ///< [N/m]
    Real gamma_n;  ///< [kg/s]
    Real k_t, gamma_t;
    Real frequency;  ///< sqrt(k_n/m_e) [rad/s]
};
using ContactCoefficients = ContactCoefficientsOf<double>;

/// Linear spring-dashpot [GC] Eqs. 13-16, corrected: k_t = k_n (1/mu)/B (pi^2 + ln^2 e_t)/(pi^2 +
/// ln^2 e_n), gamma_t = -(2/t_c) ln e_t / B.
template <class Law, class Real>
ContactCoefficientsOf<Real> linear_coefficients(const Law& law, const Real& inverse_mass,
                                                const TangentialInertiaOf<Real>& tangential) {
    ContactCoefficientsOf<Real> c{};
    c.k_n = law.normal_stiffness;
    c.frequency = root(c.k_n * inverse_mass);
    c.gamma_n = select(inverse_mass > 0.0, law.damping * c.frequency / inverse_mass, Real{});
    const MaskOf<Real> resists = tangential.inverse > 0.0;
    c.k_t = select(
        resists, c.k_n * law.tangential_stiffness * tangential.inverse_reduced / tangential.inverse,
        Real{});
    c.gamma_t = select(
        resists,
        law.tangential_damping * root(c.k_n * tangential.inverse_reduced) / tangential.inverse,
        Real{});
    return c;
}

/// `inverse_mass` = 1/m_e [1/kg].
template <class Law, class Real>
ContactCoefficientsOf<Real> contact_coefficients(const Law& law, const Real& radius,
                                                 const Real& overlap, const Real& inverse_mass,
                                                 const TangentialInertiaOf<Real>& tangential) {
    if (law.model == ContactLaw::Model::linear)
        return linear_coefficients(law, inverse_mass, tangential);
    const Real reach = root(radius * overlap);
    ContactCoefficientsOf<Real> c{};
    c.k_n = 4.0 / 3.0 * law.youngs_modulus * reach;
    c.frequency = root(c.k_n * inverse_mass);
    const Real mass = select(inverse_mass > 0.0, 1.0 / inverse_mass, Real{});
    c.gamma_n = law.damping * c.frequency * mass;
    c.k_t = law.tangential == ContactLaw::Tangential::mindlin ? 8.0 * law.shear_modulus * reach
                                                              : law.stiffness_ratio * c.k_n;
    c.gamma_t = law.damping_ratio * c.gamma_n;
    return c;
}

/// How long the normal dashpot acts in this step, in steps. A linear one sets in with its full
/// force at the touch and stops at the parting: where one of them is less than a step away it acts
/// from half a step before to half a step after now, but not beyond. Without this a restitution of
/// 0.3 is off by up to 0.01 at t_c/50. Hertz's dashpot sets in from zero.
template <class Law, class Real>
Real dashpot_share(const Law& law, const ContactCoefficientsOf<Real>& c, const Real& overlap,
                   const Real& rate, double dt) {
    if (law.model != ContactLaw::Model::linear) return in_all<Real>(1.0);
    const MaskOf<Real> approaches = rate > 0.0;
    const Real since_touch =
        select(overlap < rate * dt, 0.5 + overlap / (rate * dt), in_all<Real>(1.0));
    if (all(approaches)) return since_touch;
    // Until the next step the bodies part at the rate that this step's forces leave. A longer pull
    // must not keep them together for a step that it has counted already.
    const Real push = -rate + 0.5 * dt * square(c.frequency) * overlap;
    const Real pull = -0.5 * dt * c.frequency * law.damping * rate;
    const Real path = (push - pull) * dt;
    const Real until_parting =
        smaller<Real>(0.5 + overlap / path, 0.5 + 0.5 * (push - overlap / dt) / pull);
    const Real parting = select(both(overlap<path, pull> 0.0), until_parting, in_all<Real>(1.0));
    return select(approaches, since_touch, parting);
}

/// How a point, or one of many that share an overlap by weights, is pressed.
template <class Real>
struct PressingOf {
    Real overlap;         ///< of the contact [m]
    Real rate;            ///< of the overlap at the point [m/s]
    double weight = 1.0;  ///< of the point in the overlap; < 0 where it counts against others
};
using Pressing = PressingOf<double>;

template <class Real>
struct NormalForceOf {
    Real elastic_part;  ///< [N]
    Real size;          ///< along the gradient of the overlap, > 0 repulsive [N]
    Real dissipated;    ///< in this step [J]
};
using NormalForce = NormalForceOf<double>;

/// Spring and dashpot along the normal.
template <class Law, class Real>
NormalForceOf<Real> normal_force(const Law& law, const ContactCoefficientsOf<Real>& c,
                                 const PressingOf<Real>& point, double dt) {
    NormalForceOf<Real> f{};
    f.elastic_part = point.weight * c.k_n * point.overlap;
    const Real share = dashpot_share(law, c, point.overlap, point.rate, dt);
    f.size = f.elastic_part + share * point.weight * c.gamma_n * point.rate;
    if (law.limit_force && point.weight > 0.0) f.size = larger(f.size, Real{});
    f.dissipated = (f.size - f.elastic_part) * point.rate * dt;
    return f;
}

/// The normal force of which friction may be the share mu [N]: the elastic part of it. The dashpot
/// gives no impulse over a whole contact, but it pulls at its end; friction cut at the size of the
/// damped force would go on there, and sliding impacts would exceed Coulomb. Where the damped force
/// is itself cut at zero it serves: what the dashpot then gives does not vanish.
template <class Law, class Real>
Real friction_load(const Law& law, const Real& elastic_part, const Real& force) {
    return law.limit_force ? force : elastic_part;
}

}  // namespace dem::runtime
