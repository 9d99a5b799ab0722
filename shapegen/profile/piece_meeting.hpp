// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_piece.hpp"

#include <optional>

namespace dem::shapegen {

/// A point where two pieces that are not joined come closer than `tolerance`, if there is one.
std::optional<Vec2> meeting_point(const ProfileSegment& segment_a, const ProfilePiece& a,
                                  const ProfileSegment& segment_b, const ProfilePiece& b,
                                  double tolerance);

/// A point other than their joint where a piece and the one that continues it come closer than
/// `tolerance`, if one bends back to the other.
std::optional<Vec2> second_meeting_point(const ProfileSegment& segment_a, const ProfilePiece& a,
                                         const ProfileSegment& segment_b, const ProfilePiece& b,
                                         double tolerance);

}  // namespace dem::shapegen
