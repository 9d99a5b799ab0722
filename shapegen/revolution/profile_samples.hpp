// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"

#include <vector>

namespace dem::shapegen {

/// A point exactly on the profile. Joints appear twice, as the end of one segment and the start of
/// the next.
struct ProfileSample {
    std::size_t segment;
    double t;
    Vec2 point;                 ///< (r, z) [m]
    double arc_length;          ///< from the bottom end, summed over chords [m]
    double meridional_turning;  ///< |kappa_1| [1/m]
};

/// Samples of the whole profile, bottom to top, no chord longer than `step` [m] and at least eight
/// chords on every curved segment.
std::vector<ProfileSample> sample_profile(const Profile& profile, double step);

/// The largest distance of a point of the profile from the origin [m].
double farthest_distance(const Profile& profile);

}  // namespace dem::shapegen
