// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"

#include <algorithm>
#include <cmath>

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
inline double effective_radius(const ContactLaw& law, double local_radius,
                               const ContactHistory& history) {
    const bool keeps =
        law.geometry.radius != ContactLaw::Radius::local && history.effective_radius > 0.0;
    return keeps ? history.effective_radius : local_radius;
}

/// How a contact ages in a step.
struct Ageing {
    double local_radius;  ///< R* of the place [m]
    double radius;        ///< R* of the step [m]
    double turn;          ///< of its own oscillation [rad]
    double elastic;       ///< energy of the normal spring [J]
};

/// Lets R* drift, ages the contact and returns what the change of R* took away of the energy of the
/// normal spring [J], which goes with sqrt(R*). What it takes from the tangential spring,
/// restiffen() finds in the next step. `history.dissipated`, up to date, bounds what the drift
/// gives or takes: bodies that dissipate nothing neither gain nor lose by it.
inline double age(const ContactLaw& law, const Ageing& by, ContactHistory& history) {
    double radius = by.radius;
    double loss = 0.0;
    if (law.model == ContactLaw::Model::linear) {
        // The stiffness knows no radius.
    } else if (law.geometry.radius == ContactLaw::Radius::local) {
        if (history.effective_radius > 0.0)
            loss = 0.5 * (history.effective_radius / radius - 1.0) * by.elastic;
    } else if (law.geometry.radius == ContactLaw::Radius::onset &&
               history.phase >= settled_phase + drift_interval) {
        const double drifted = radius + (by.local_radius - radius) * (drift_interval / drift_phase);
        const double most = std::max(history.dissipated, 0.0) / by.elastic;
        const double root = std::clamp(std::sqrt(drifted / radius), 1.0 - most, 1.0 + most);
        radius *= square(root);
        loss = (1.0 - root) * by.elastic;
        history.phase -= drift_interval;
    }
    history.effective_radius = radius;
    history.phase += by.turn;
    history.dissipated += loss;
    return loss;
}

}  // namespace dem::runtime
