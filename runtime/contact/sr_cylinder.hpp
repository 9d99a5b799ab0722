// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/support_sample.hpp"
#include "runtime/contact/wall_shapes.hpp"
#include "runtime/contact_law/contact_point.hpp"

#include <array>

namespace dem {

/// Where a convex body touches a cylinder wall.
struct WallTouch {
    std::array<ContactPoint, PatchHistory::slot_count> points;
    std::size_t count = 0;  ///< 0: apart
    SupportSample deepest;  ///< of the body at the deepest point
    double gap = 0.0;       ///< proven distance when apart [m]; 0: unknown
};

/// How a body stands to a cylinder wall.
struct WallPose {
    Vec3 axis;    ///< of the wall, unit
    Vec3 center;  ///< of the body relative to the wall's origin [m]
};

/// Inside: every place where the body's outline across the axis reaches farthest, beyond the
/// radius. Bodies flatter than the cylinder have several; of more than PatchHistory holds the
/// deepest. The search begins where the history says that they touched.
WallTouch touch_inside(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                       const WallPose& pose, const PatchHistory& history);

/// A solid rod from outside, convex against convex: at its side, at an end face or at the edge
/// between.
WallTouch touch_rod(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                    const WallPose& pose);

/// Numbers the points so that each keeps its place in the history as it moves along the wall: every
/// point takes the number of the slot whose normal is nearest to its own, new ones free numbers.
/// Leaves the points in the order of their numbers.
void give_features(WallTouch& touch, const PatchHistory& history);

}  // namespace dem
