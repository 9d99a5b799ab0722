// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/profile/profile.hpp"
#include "shapegen/revolution/support_link.hpp"

#include <vector>

namespace dem::shapegen {

/// Pieces of a support map in rising normal, each with the last of its normals.
class SupportPieces {
  public:
    /// `size`: l [m].
    explicit SupportPieces(double size) : size_(size) {}

    /// One piece up to `last_normal`; nothing when no direction is left for it.
    void append(const SupportPiece& piece, const Vec2& last_normal);
    void append_corner(const Vec2& point, const Vec2& last_normal);

    /// Two circular arcs, tangent to each other, from a point with its normal to another; they join
    /// at the normal of the chord, which makes both radii positive for any convex data.
    void append_biarc(const SupportLink& link);

    /// One arc about a center on the axis, from the pole to the rim or back. The pole moves
    /// outwards.
    void append_end_face(const SupportLink& link);

    /// A curved link: one piece for an ellipse arc, otherwise biarcs cut at the middle of the
    /// normals until each turns by less than 90/128 deg and is within 2e-8 l of the curve, or is as
    /// flat as a crown.
    void append_curve(const ProfileSegment& segment, const SupportLink& link);

    std::vector<SupportPiece> take_pieces() { return std::move(pieces_); }
    std::vector<double> take_ends() { return std::move(ends_); }

  private:
    void append_spline(const ProfileSegment& segment, const SupportLink& link, int depth);

    double size_;
    std::vector<SupportPiece> pieces_;
    std::vector<double> ends_;
};

/// q of sr_shape.hpp for a normal.
double direction_measure(const Vec2& normal);

}  // namespace dem::shapegen
