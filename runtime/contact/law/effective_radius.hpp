// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"

/// R* of a contact over its life (docs/contact.md, "Effective radius").
namespace dem::runtime {

/// How long an elastic collision of two Hertzian bodies lasts, in radians of its own oscillation:
/// the integral of sqrt(k_n/m_e) dt is 2 pi / sqrt(5) at any speed, mass and stiffness.
inline constexpr double collision_phase = 2.8099258924162904;

/// A contact older than this is not a collision any more: its R* starts to follow the geometry.
inline constexpr double settled_phase = 4.0 * collision_phase;

/// Time constant of that drift: slow against the contact's own oscillation, so that what the change
/// of stiffness adds or takes in a cycle stays below what it would in a bounce by that factor.
inline constexpr double drift_phase = 20.0 * collision_phase;

/// The drift goes in small jumps, one each time the contact has aged by this many radians: R* of
/// the place is needed then and only then.
inline constexpr double drift_interval = 0.25;

/// Whether the law asks for R* at the present place, or for none because the frozen one serves.
inline bool needs_local_radius(const ContactLaw& law, const ContactHistory& history) {
    const ContactLaw::Radius rule = law.geometry.radius;
    return rule == ContactLaw::Radius::local || history.effective_radius == 0.0 ||
           (rule == ContactLaw::Radius::onset && history.phase >= settled_phase + drift_interval);
}

/// R* of this step [m].
template <class Law, class Real, class History>
Real effective_radius(const Law& law, const Real& local_radius, const History& history) {
    if (law.geometry.radius == ContactLaw::Radius::local) return local_radius;
    return select(history.effective_radius > 0.0, Real(history.effective_radius), local_radius);
}

/// How a contact ages in a step.
template <class Real>
struct AgeingOf {
    Real local_radius;  ///< R* of the place [m]
    Real radius;        ///< R* of the step [m]
    Real turn;          ///< of its own oscillation [rad]
    Real elastic;       ///< energy of the normal spring [J]
};
using Ageing = AgeingOf<double>;

/// Lets R* drift where it is time, and returns what that took away of the energy of the normal
/// spring [J].
template <class Real, class History>
Real drift_radius(const AgeingOf<Real>& by, Real& radius, History& history) {
    const MaskOf<Real> drifts = history.phase >= settled_phase + drift_interval;
    if (!any(drifts)) return Real{};
    const Real drifted = radius + (by.local_radius - radius) * (drift_interval / drift_phase);
    const Real most = larger<Real>(history.dissipated, Real{}) / by.elastic;
    const Real share = clamped<Real>(root(drifted / radius), 1.0 - most, 1.0 + most);
    radius = select(drifts, radius * square(share), radius);
    history.phase = select(drifts, history.phase - drift_interval, Real(history.phase));
    return select(drifts, (1.0 - share) * by.elastic, Real{});
}

/// Lets R* drift, ages the contact and returns what the change of R* took away of the energy of the
/// normal spring [J], which goes with sqrt(R*). What it takes from the tangential spring,
/// restiffen() finds in the next step. `history.dissipated`, up to date, bounds what the drift
/// gives or takes: bodies that dissipate nothing neither gain nor lose by it.
template <class Law, class Real, class History>
Real age(const Law& law, const AgeingOf<Real>& by, History& history) {
    Real radius = by.radius;
    Real loss{};
    if (law.model == ContactLaw::Model::linear) {
        // The stiffness knows no radius.
    } else if (law.geometry.radius == ContactLaw::Radius::local) {
        loss = select(history.effective_radius > 0.0,
                      0.5 * (history.effective_radius / radius - 1.0) * by.elastic, Real{});
    } else if (law.geometry.radius == ContactLaw::Radius::onset) {
        loss = drift_radius(by, radius, history);
    }
    history.effective_radius = radius;
    history.phase += by.turn;
    history.dissipated += loss;
    return loss;
}

}  // namespace dem::runtime
