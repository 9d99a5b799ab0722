// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/smooth/support_sample.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

#include <array>

namespace dem::runtime {

/// Where a convex body touches a cylinder wall.
struct WallTouch {
    std::array<ContactPoint, PatchHistory::slot_count> points;
    std::size_t count = 0;  ///< 0: apart
    /// Between two neighbors of `points` that both touch, where the overlap is least.
    std::array<ContactPoint, PatchHistory::slot_count> between;
    std::size_t between_count = 0;
    SupportSample deepest;  ///< of the body at the deepest point
    double gap = 0.0;       ///< proven distance when apart [m]; 0: unknown

    /// Adds a point of the body where it is `overlap` beyond a wall of the outward normal n; x is
    /// relative to the body's center. A full list keeps the deepest.
    void add(const Vec3& x, const Vec3& n, double overlap, const SupportSample& support);
};

/// How a body stands to a cylinder wall.
struct WallPose {
    Vec3 axis;    ///< of the wall, unit
    Vec3 center;  ///< of the body relative to the wall's origin [m]
};

/// Inside: every place where the body's outline across the axis reaches farthest, beyond the
/// radius. Bodies flatter than the cylinder have several; of more than PatchHistory holds the
/// deepest. Two places that become one do so together with the place between them. The search
/// begins where the history says that they touched.
WallTouch touch_inside(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                       const WallPose& pose, const PatchHistory& history);

/// Numbers the points so that each keeps its place in the history as it moves along the wall: every
/// point takes the number of the slot whose normal is nearest to its own, new ones free numbers.
/// Leaves the points in the order of their numbers.
void give_features(WallTouch& touch, const PatchHistory& history);

}  // namespace dem::runtime
