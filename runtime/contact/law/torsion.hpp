// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/slipping_spring.hpp"
#include "runtime/contact/law/whole_contact.hpp"

#include <cmath>

/// Friction of an area against twisting about its normal (docs/contact-convex.md, "Friction"): what
/// the tangential spring is to sliding.
namespace dem::runtime {

struct TorsionHistory {
    double twist = 0.0;            ///< relative rotation about the normal, half a step ahead [rad]
    double twist_stiffness = 0.0;  ///< of the step before [N m]
};

inline double held_energy(const TorsionHistory& history) {
    return 0.5 * history.twist_stiffness * square(history.twist);
}

/// The torsion spring of an area with this tangential one, its points a mean squared distance of
/// `spread2` from their center.
inline SlippingSpring torsion_spring(const SlippingSpring& tangential, double spread2) {
    return {tangential.k * spread2, tangential.gamma * spread2,
            tangential.limit * std::sqrt(spread2)};
}

/// Moment on i along the normal [N m]; its negative acts on j.
inline double torsion_moment(const SlippingSpring& s, double rate, double dt,
                             TorsionHistory& history, ContactEnergy& energy) {
    // Friction that is new to the patch starts without stretch: the moment stays, a part of the
    // twist goes. What leaves the patch takes its energy along.
    const double before = history.twist_stiffness;
    const double kept = s.k > before ? before / s.k : 1.0;
    energy.dissipated += 0.5 * (before - s.k * square(kept)) * square(history.twist);
    history.twist_stiffness = s.k;
    Vec3 lead(0.0, 0.0, kept * history.twist);
    const SpringForce f = slipping_force(s, Vec3(0.0, 0.0, rate), dt, lead);
    history.twist = s.k > 0.0 ? lead.z() : 0.0;
    energy.elastic += f.elastic;
    energy.dissipated += f.dissipated;
    return f.force.z();
}

}  // namespace dem::runtime
