// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"

#include <optional>
#include <vector>

namespace dem::shapegen {

/// A stretch of a convex profile between two points with their outward normals: a part of a curved
/// segment, or a flat one that is to be crowned. Normals rise (turn left) along a profile.
struct SupportLink {
    Vec2 from, to;
    Vec2 first_normal, last_normal;
    /// Curved links: the segment and the part of its parameter.
    std::optional<std::size_t> segment;
    double t0 = 0.0, t1 = 0.0;
    /// A flat that meets the axis squarely: its crown is an arc about a center on the axis.
    bool is_end_face = false;

    bool is_flat() const { return !segment; }
};

/// Angle by which `to` is turned to the left of `from` [rad].
double turn(const Vec2& from, const Vec2& to);

/// The links of a convex profile, bottom to top. Flats have their crowned normals; where the
/// normals of two consecutive links differ there is a corner, otherwise one ends at the point and
/// the normal where the next begins.
std::vector<SupportLink> support_links(const Profile& profile);

/// Parameter of the point of a convex curved segment with the given outward normal, in [t0, t1].
double parameter_of_normal(const ProfileSegment& segment, const Vec2& normal, double t0, double t1);

}  // namespace dem::shapegen
