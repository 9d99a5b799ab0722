// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/sr_tube.hpp"

namespace dem::runtime {

/// A solid rod from outside, convex against convex: at its side, at an end face or at the edge
/// between, where the overlap is the least (rival_normal.hpp).
WallTouch touch_rod(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                    const WallPose& pose);

}  // namespace dem::runtime
