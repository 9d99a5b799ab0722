// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

namespace dem::runtime {

/// Where the bodies of a pair were when something was found that stays true as long as they hardly
/// move. All zero: nothing was found.
struct Leash {
    double room = 0.0;    ///< for the motion of any point of j in the frame of i [m]
    StoredVec3 center;    ///< of j in the frame of i [m]
    StoredVec3 turn;      ///< of j in that frame, a quaternion, and
    double turn_w = 0.0;  ///< its scalar
};

Leash leash_at(const PairState& pair, double room);

/// Whether no point of j, which is of this size, has moved by more than the room [m].
bool holds(const Leash& leash, const PairState& pair, double size);

}  // namespace dem::runtime
