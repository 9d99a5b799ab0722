// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_segment.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace dem::shapegen {

/// Nearest point of a profile to a query point.
struct ProfilePoint {
    Vec2 point = Vec2::Zero();
    std::size_t segment = 0;
    double t = 0.0;
    double distance = std::numeric_limits<double>::infinity();  ///< unsigned [m]
};

/// A part of a segment that turns little, with bounds that tell from its chord alone where the
/// curve can be: what searches along a profile are made on. The bounds are exact for lines and
/// circular arcs; for other curves they come from samples of the curvature, widened by half of its
/// variation.
struct ProfilePiece {
    Vec2 from, to;
    Vec2 first_tangent, last_tangent;  ///< derivatives by t at the ends
    double t0, t1;
    std::uint32_t segment;
    double bulge;          ///< no point of the piece is farther from its chord [m]
    double min_curvature;  ///< signed, positive to the left [1/m]
    double max_curvature;
    double turn;  ///< tangents of two points of the piece differ by no more [rad]
};

/// Cuts a segment into pieces that turn by less than 0.1 rad (lines and circular arcs are not cut
/// finer than that) and appends them in the order of the path.
void append_pieces(const ProfileSegment& segment, std::uint32_t index,
                   std::vector<ProfilePiece>& pieces);

/// The two halves of a piece in the parameter, with bounds that shrink accordingly.
std::array<ProfilePiece, 2> halves(const ProfileSegment& segment, const ProfilePiece& piece);

/// Replaces `best` by the nearest point of the piece to x when that is nearer. Exact: closed form
/// on lines and circular arcs; on other curves the piece is halved until the distance has one
/// minimum on each part, which Newton's method finds inside a bracket.
void improve_nearest(const ProfileSegment& segment, const ProfilePiece& piece, const Vec2& x,
                     ProfilePoint& best);

/// Largest value of direction . c(t) on the piece (one maximum: the piece turns little).
double largest_along(const ProfileSegment& segment, const ProfilePiece& piece,
                     const Vec2& direction);

/// Distance of x from the segment a-b [m].
double distance_to_chord(const Vec2& x, const Vec2& a, const Vec2& b);

}  // namespace dem::shapegen
