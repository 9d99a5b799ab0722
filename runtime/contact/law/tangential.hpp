// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/slipping_spring.hpp"
#include "runtime/contact/law/whole_contact.hpp"

/// Friction along the surface (docs/contact.md, "Tangential spring", "Without slip"):
///   F_t = -k_t s - gamma_t u_t, |F_t| <= mu times the load
namespace dem::runtime {

/// How the surfaces slide at a place, and how the contact has turned since the step before.
template <class Real>
struct SlidingOf {
    Vec3Of<Real> velocity;     ///< of i relative to j at the place [m/s]
    Vec3Of<Real> normal;       ///< unit
    Vec3Of<Real> last_normal;  ///< in the step before
    Real turn;                 ///< of the contact about the normal in this step [rad]
    MaskOf<Real> is_new;       ///< the place did not touch in the step before
    double dt;                 ///< [s]
};
using Sliding = SlidingOf<double>;

/// Friction at a place [N], on i: its spring, carried to where the contact is now, with the
/// stiffness of now. `taken`: what the contact has dissipated before this step [J].
template <class Real, class History>
Vec3Of<Real> friction_force(const SlippingSpringOf<Real>& s, const SlidingOf<Real>& by,
                            const Real& taken, History& history, ContactEnergyOf<Real>& energy) {
    const Vec3Of<Real>& n = by.normal;
    const Vec3Of<Real> u_t = by.velocity - by.velocity.dot(n) * n;
    const Vec3Of<Real> none = Vec3Of<Real>::Zero();
    Vec3Of<Real> spring = none;
    if (!all(by.is_new)) {
        const Vec3Of<Real> last = history.spring;
        spring = select(by.is_new, none, carried(last, by.last_normal, n, by.turn));
    }
    energy.dissipated += restiffen<Real>(history.stiffness, s.k, taken + energy.dissipated, spring);
    const SpringForceOf<Real> f = slipping_force(s, u_t, by.dt, spring);
    history.spring = spring;
    history.stiffness = s.k;
    energy.elastic += f.elastic;
    energy.dissipated += f.dissipated;
    return f.force;
}

/// From this coefficient of friction on, contacts of convex shapes under the linear law give back
/// what their tangential spring holds when they end (docs/contact.md, "Without slip").
inline constexpr double no_slip = 2.0;

inline bool gives_back(const ContactLaw& law) {
    return law.model == ContactLaw::Model::linear && law.friction > no_slip;
}

struct LettingGo {
    double force;   ///< of the spring, against it [N]
    double push;    ///< along the normal, repulsive [N]
    double energy;  ///< [J]
};

/// A spring of stiffness k_t and length s that is longer than `ratio` overlaps d: with h = ratio d
///     U = k_t (h^2 - h^4 / (2 s^2)),    force dU/ds, push dU/dd,
/// which goes on from k_t s^2 / 2 at s = h without a kink and vanishes with the overlap.
inline LettingGo letting_go(double k_t, double s, double ratio, double overlap) {
    const double h = ratio * overlap;
    const double r2 = square(h / s);
    return {k_t * h * r2 * h / s, 2.0 * k_t * h * ratio * (1.0 - r2),
            k_t * square(h) * (1.0 - 0.5 * r2)};
}

}  // namespace dem::runtime
