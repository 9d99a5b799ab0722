// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

namespace dem::runtime {

/// A contact as a whole, as the parts of the law see it that act once per pair, however many points
/// touch.
struct WholeContact {
    const PairState& pair;
    double dt;         ///< [s]
    bool is_new;       ///< the bodies did not touch in the step before
    Vec3 normal;       ///< unit, from j towards i
    Vec3 last_normal;  ///< in the step before
    Vec3 center;       ///< of the load, relative to the center of i [m]
    double stiffness;  ///< load over overlap [N/m]
    double load;       ///< that friction is a share of [N]
    double taken;      ///< dissipated by the contact before this step [J]
};

struct ContactEnergy {
    double elastic = 0.0;     ///< stored [J]
    double dissipated = 0.0;  ///< in this step [J]
};

}  // namespace dem::runtime
