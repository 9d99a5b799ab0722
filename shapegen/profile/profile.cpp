// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/profile/profile_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem::shapegen {
namespace {

/// Outward is to the right of a path that has the axis on its left.
Vec2 right_normal(const Vec2& tangent) {
    return Vec2(tangent.y(), -tangent.x()).normalized();
}

double signed_turn(const Vec2& from, const Vec2& to) {
    return math::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

double extent(std::span<const ProfileSegment> segments, std::span<const ProfilePiece> pieces,
              const Vec2& direction) {
    double best = -std::numeric_limits<double>::infinity();
    for (const ProfilePiece& piece : pieces) {
        const double bound = std::max(direction.dot(piece.from), direction.dot(piece.to));
        if (bound + piece.bulge > best)
            best = std::max(best, largest_along(segments[piece.segment], piece, direction));
    }
    return best;
}

}  // namespace

Profile::Profile(std::vector<ProfileSegment> segments, std::vector<std::string> labels)
    : segments_(std::move(segments)), labels_(std::move(labels)) {
    labels_.resize(segments_.size());
    check_path(segments_, labels_);
    tree_ = PieceTree(segments_);
    for (const ProfileSegment& segment : segments_) length_ += arc_length(segment);
    max_radius_ = extent(segments_, pieces(), Vec2::UnitX());
    max_z_ = extent(segments_, pieces(), Vec2::UnitY());
    min_z_ = -extent(segments_, pieces(), -Vec2::UnitY());
    check_shape(segments_, labels_, tree_, major_axis_length());
}

double Profile::bottom_z() const {
    return evaluate(segments_.front(), 0.0).point.y();
}

double Profile::top_z() const {
    return evaluate(segments_.back(), 1.0).point.y();
}

double Profile::major_axis_length() const {
    return std::max(max_z_ - min_z_, 2.0 * max_radius_);
}

double Profile::signed_distance(const Vec2& x) const {
    const Vec2 query(std::abs(x.x()), x.y());
    const ProfilePoint found = nearest(query);
    return pseudo_normal(found).dot(query - found.point) < 0.0 ? -found.distance : found.distance;
}

bool Profile::contains(const Vec2& x) const {
    return signed_distance(x) < 0.0;
}

/// A direction whose product with (x - nearest point) has the sign of the distance: the normal, and
/// in a joint the sum of both normals (at a pole the mirror image is the other side).
Vec2 Profile::pseudo_normal(const ProfilePoint& nearest) const {
    constexpr double at_end = 1e-12;
    const std::size_t k = nearest.segment;
    Vec2 normal = outward_normal(k, nearest.t);
    const Vec2 mirrored(-normal.x(), normal.y());
    if (nearest.t <= at_end) return normal + (k == 0 ? mirrored : outward_normal(k - 1, 1.0));
    if (nearest.t >= 1.0 - at_end)
        return normal + (k + 1 == segments_.size() ? mirrored : outward_normal(k + 1, 0.0));
    return normal;
}

Vec2 Profile::outward_normal(std::size_t segment, double t) const {
    return right_normal(evaluate(segments_[segment], t).first);
}

std::vector<Profile::Corner> Profile::corners(double max_angle) const {
    std::vector<Corner> corners;
    const auto add = [&](std::size_t segment, const Vec2& point, double turn) {
        if (pi - turn < max_angle) corners.push_back({segment, point, pi - turn});
    };
    const CurveJet bottom = evaluate(segments_.front(), 0.0);
    add(segments_.size(), bottom.point, 2.0 * math::atan2(bottom.first.y(), bottom.first.x()));
    for (std::size_t i = 1; i < segments_.size(); ++i) {
        const CurveJet start = evaluate(segments_[i], 0.0);
        add(i - 1, start.point, signed_turn(evaluate(segments_[i - 1], 1.0).first, start.first));
    }
    const CurveJet top = evaluate(segments_.back(), 1.0);
    add(segments_.size() - 1, top.point, 2.0 * math::atan2(top.first.y(), -top.first.x()));
    return corners;
}

Profile Profile::translated(double dz) const {
    Profile moved = *this;
    for (ProfileSegment& segment : moved.segments_)
        segment = shapegen::translated(segment, Vec2(0.0, dz));
    moved.tree_ = PieceTree(moved.segments_);
    moved.min_z_ += dz;
    moved.max_z_ += dz;
    return moved;
}

}  // namespace dem::shapegen
