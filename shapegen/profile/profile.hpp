// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/piece_tree.hpp"

#include <span>
#include <string>
#include <vector>

/// The generating curve of a surface of revolution: an ordered path in the half plane (r, z), r >=
/// 0, from the lower end of the axis to the upper one. Lengths in meters.
namespace dem::shapegen {

/// A closed generating curve: first and last points lie on the axis (r == 0), consecutive segments
/// join, it does not cross itself and encloses a volume. The constructor checks all of that and
/// throws Error naming the segment (by `labels`, e.g. "tablet.profile:12") and the point.
class Profile {
  public:
    /// `labels`: one text per segment for messages; end faces added by the caller carry their own.
    Profile(std::vector<ProfileSegment> segments, std::vector<std::string> labels);

    std::span<const ProfileSegment> segments() const { return segments_; }
    const std::string& label(std::size_t segment) const { return labels_[segment]; }

    double length() const { return length_; }          ///< arc length [m]
    double max_radius() const { return max_radius_; }  ///< [m]
    double bottom_z() const;                           ///< lower end on the axis [m]
    double top_z() const;                              ///< upper end on the axis [m]
    double min_z() const { return min_z_; }  ///< lowest point [m]; below bottom_z() when dimpled
    double max_z() const { return max_z_; }  ///< highest point [m]
    double major_axis_length() const;        ///< l = max(height, 2 max_radius) [m]

    /// Exact nearest point (not of a polyline) to a point of the half plane, r >= 0.
    ProfilePoint nearest(const Vec2& x) const { return tree_.nearest(segments_, x); }
    /// Exact signed distance, negative inside [m]. By symmetry r < 0 is the same as -r.
    double signed_distance(const Vec2& x) const;
    bool contains(const Vec2& x) const;

    /// Outward unit normal at a point of a segment.
    Vec2 outward_normal(std::size_t segment, double t) const;

    /// The path cut into parts that turn by less than 0.1 rad, in its order.
    std::span<const ProfilePiece> pieces() const { return tree_.pieces(); }

    /// Joints (index = the segment that ends there) whose interior angle is below `max_angle`
    /// [rad]; the poles are included when the profile meets the axis at such an angle.
    struct Corner {
        std::size_t segment;  ///< ends at the corner; segments().size() for the bottom pole
        Vec2 point;
        double interior_angle;
    };
    std::vector<Corner> corners(double max_angle = 170.0 * pi / 180.0) const;

    /// Moves the whole profile along z.
    Profile translated(double dz) const;

  private:
    Vec2 pseudo_normal(const ProfilePoint& nearest) const;

    std::vector<ProfileSegment> segments_;
    std::vector<std::string> labels_;
    PieceTree tree_;
    double length_ = 0.0;
    double max_radius_ = 0.0;
    double min_z_ = 0.0;
    double max_z_ = 0.0;
};

}  // namespace dem::shapegen
