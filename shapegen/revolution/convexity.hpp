// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"

namespace dem::shapegen {

/// How far a body of revolution is from its convex hull.
struct Convexity {
    bool is_convex = false;
    double hull_distance = 0.0;  ///< deepest point of the surface below the hull [m]
};

/// Deepest dent that still counts as convex, relative to l. Profiles come from files with five or
/// six digits, so that joints meant to be smooth are dented by up to about 1e-6; the support map of
/// a convex body replaces the body by its hull and is itself off by 3e-5 l where flats are crowned.
inline constexpr double convexity_tolerance = 1e-6;

/// Convexity of the body, not of the half profile: a cone standing on its tip is convex, a body
/// with a dimple on the axis is not. Distance to the hull of dense samples of the mirrored profile.
Convexity convexity(const Profile& profile);

}  // namespace dem::shapegen
