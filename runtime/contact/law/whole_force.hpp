// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/effective_radius.hpp"

namespace dem::runtime {

/// The end of every contact's step, after its normal forces and its friction: the parts that act
/// once per contact, then its history. Returns the moment on i [N m]; -moment acts on j.
template <class Law, class Pair, class Real, class History>
Vec3Of<Real> end_step(const Law& law, const WholeContactOf<Pair>& contact,
                      const AgeingOf<Real>& ageing, History& history,
                      ContactEnergyOf<Real>& energy) {
    Vec3Of<Real> moment = moment_of_parts(law, contact, history, energy);
    history.normal = contact.normal;
    history.dissipated += energy.dissipated;
    energy.dissipated += age(law, ageing, history);
    return moment;
}

}  // namespace dem::runtime
