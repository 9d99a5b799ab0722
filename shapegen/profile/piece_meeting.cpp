// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/piece_meeting.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/profile/plane.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

double side(const Vec2& a, const Vec2& b, const Vec2& x) {
    return (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
}

/// Distance of the chords of two pieces; 0 when they cross.
double chord_distance(const ProfilePiece& a, const ProfilePiece& b) {
    const bool a_parts_b = (side(a.from, a.to, b.from) > 0.0) != (side(a.from, a.to, b.to) > 0.0);
    const bool b_parts_a = (side(b.from, b.to, a.from) > 0.0) != (side(b.from, b.to, a.to) > 0.0);
    if (a_parts_b && b_parts_a) return 0.0;
    return std::min(
        std::min(distance_to_chord(a.from, b.from, b.to), distance_to_chord(a.to, b.from, b.to)),
        std::min(distance_to_chord(b.from, a.from, a.to), distance_to_chord(b.to, a.from, a.to)));
}

}  // namespace

std::optional<Vec2> meeting_point(const ProfileSegment& segment_a, const ProfilePiece& a,
                                  const ProfileSegment& segment_b, const ProfilePiece& b,
                                  double tolerance) {
    const double gap = chord_distance(a, b);
    if (gap - a.bulge - b.bulge > tolerance) return std::nullopt;
    if (a.bulge <= tolerance && b.bulge <= tolerance) return Vec2(0.5 * (a.from + a.to));
    if (a.bulge >= b.bulge) {
        for (const ProfilePiece& half : halves(segment_a, a))
            if (auto point = meeting_point(segment_a, half, segment_b, b, tolerance)) return point;
    } else {
        for (const ProfilePiece& half : halves(segment_b, b))
            if (auto point = meeting_point(segment_a, a, segment_b, half, tolerance)) return point;
    }
    return std::nullopt;
}

std::optional<Vec2> second_meeting_point(const ProfileSegment& segment_a, const ProfilePiece& a,
                                         const ProfileSegment& segment_b, const ProfilePiece& b,
                                         double tolerance) {
    // Seen from the joint, each piece stays within its turn of its own tangent there: while these
    // two cones are apart the pieces cannot meet again.
    const Vec2 back = -a.last_tangent;
    const Vec2& ahead = b.first_tangent;
    if (a.turn + b.turn < angle_between(back, ahead)) return std::nullopt;
    if ((a.to - a.from).norm() <= tolerance || (b.to - b.from).norm() <= tolerance)
        return std::nullopt;
    const auto [a_far, a_near] = halves(segment_a, a);
    const auto [b_near, b_far] = halves(segment_b, b);
    if (auto point = meeting_point(segment_a, a_far, segment_b, b_near, tolerance)) return point;
    if (auto point = meeting_point(segment_a, a_far, segment_b, b_far, tolerance)) return point;
    if (auto point = meeting_point(segment_a, a_near, segment_b, b_far, tolerance)) return point;
    return second_meeting_point(segment_a, a_near, segment_b, b_near, tolerance);
}

}  // namespace dem::shapegen
