// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/lanes.hpp"
#include "runtime/contact/contact_types.hpp"

namespace dem::runtime {

/// A contact as a whole, as the parts of the law see it that act once per pair, however many points
/// touch.
template <class Pair>
struct WholeContactOf {
    using Real = typename Pair::Real;
    const Pair& pair;
    double dt;                 ///< [s]
    MaskOf<Real> is_new;       ///< the bodies did not touch in the step before
    Vec3Of<Real> normal;       ///< unit, from j towards i
    Vec3Of<Real> last_normal;  ///< in the step before
    Vec3Of<Real> center;       ///< of the load, relative to the center of i [m]
    Real stiffness;            ///< load over overlap [N/m]
    Real load;                 ///< that friction is a share of [N]
    Real taken;                ///< dissipated by the contact before this step [J]
};
using WholeContact = WholeContactOf<PairState>;

template <class Real>
struct ContactEnergyOf {
    Real elastic{};     ///< stored [J]
    Real dissipated{};  ///< in this step [J]
};
using ContactEnergy = ContactEnergyOf<double>;

}  // namespace dem::runtime
