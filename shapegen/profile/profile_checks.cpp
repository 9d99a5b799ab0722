// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_checks.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dem::shapegen {
namespace {

constexpr double join_tolerance = 1e-9;    // of the size of the path
constexpr double touch_tolerance = 1e-12;  // of the size of the path

std::string text(const Vec2& point) {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "(r, z) = (%.6g, %.6g) m", point.x(), point.y());
    return buffer;
}

constexpr double smallest_size = 1e-9;  // [m]
constexpr double largest_size = 1e4;    // [m]
constexpr double largest_aspect = 1e4;

/// Extent of the segments in r and z [m]; the larger is the scale of all tolerances.
Vec2 path_extent(std::span<const ProfileSegment> segments) {
    Vec2 lower = evaluate(segments.front(), 0.0).point;
    Vec2 upper = lower;
    for (const ProfileSegment& segment : segments)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec2 point = evaluate(segment, t).point;
            lower = lower.cwiseMin(point);
            upper = upper.cwiseMax(point);
        }
    return upper - lower;
}

/// Beyond these bounds squares and fourth powers of lengths leave the range of numbers, and
/// tolerances relative to the size swallow the thickness.
void check_extent(const Vec2& extent, const std::string& label) {
    const double size = extent.maxCoeff();
    char found[96];
    if (!(size >= smallest_size && size <= largest_size)) {
        std::snprintf(found, sizeof found, "the profile has a size of %.3g m", size);
        throw Error(label, std::string(found) + ", expected 1e-9 to 1e4 m; check its units");
    }
    // No extent at all is a matter of the checks that follow.
    if (extent.minCoeff() > 0.0 && size > largest_aspect * extent.minCoeff()) {
        std::snprintf(found, sizeof found, "the profile reaches %.3g m in r and %.3g m in z",
                      extent.x(), extent.y());
        throw Error(label, std::string(found) + ", expected a ratio of at most 10000");
    }
}

/// Whether a piece comes down to the axis anywhere but at an end of the path.
class AxisCheck {
  public:
    AxisCheck(const ProfileSegment& segment, const std::string& label, double tolerance)
        : segment_(segment), label_(label), tolerance_(tolerance) {}

    void check(const ProfilePiece& piece, bool starts_on_axis, bool ends_on_axis) const {
        const double lowest = std::min(piece.from.x(), piece.to.x()) - piece.bulge;
        if (lowest > tolerance_) return;
        if (!starts_on_axis) check_radius(piece.from);
        if (!ends_on_axis) check_radius(piece.to);
        if (piece.bulge <= tolerance_) {
            check_flat(piece, starts_on_axis, ends_on_axis);
            return;
        }
        if ((starts_on_axis && leaves_axis(piece, piece.t0, 1.0)) ||
            (ends_on_axis && leaves_axis(piece, piece.t1, -1.0)))
            return;
        const auto [lower, upper] = halves(segment_, piece);
        check(lower, starts_on_axis, false);
        check(upper, false, ends_on_axis);
    }

  private:
    void check_radius(const Vec2& point) const {
        if (point.x() < -tolerance_)
            throw Error(label_, "the radius is negative at " + text(point) + ", expected r >= 0");
        if (point.x() <= tolerance_)
            throw Error(label_, "the profile touches the axis at " + text(point) +
                                    ", expected it to do so only at its two ends");
    }
    void check_flat(const ProfilePiece& piece, bool starts_on_axis, bool ends_on_axis) const {
        if (starts_on_axis && ends_on_axis)
            throw Error(label_, "the profile runs along the axis at " + text(piece.to) +
                                    ", expected it to enclose a volume");
    }
    /// By its turn the piece cannot come back to the axis that it left at an angle.
    bool leaves_axis(const ProfilePiece& piece, double t, double sense) const {
        const Vec2 tangent = sense * evaluate(segment_, t).first.normalized();
        return math::asin(std::clamp(tangent.x(), -1.0, 1.0)) > piece.turn;
    }

    const ProfileSegment& segment_;
    const std::string& label_;
    double tolerance_;
};

void check_axis(std::span<const ProfileSegment> segments, std::span<const std::string> labels,
                std::span<const ProfilePiece> pieces, double tolerance) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::size_t k = pieces[i].segment;
        AxisCheck(segments[k], labels[k], tolerance)
            .check(pieces[i], i == 0, i + 1 == pieces.size());
    }
}

void check_folds(std::span<const ProfileSegment> segments, std::span<const std::string> labels) {
    constexpr double smallest_angle = 1e-6;
    for (std::size_t i = 1; i < segments.size(); ++i) {
        const Vec2 back = -evaluate(segments[i - 1], 1.0).first;
        const CurveJet ahead = evaluate(segments[i], 0.0);
        const double sine = std::abs(back.x() * ahead.first.y() - back.y() * ahead.first.x());
        if (math::atan2(sine, back.dot(ahead.first)) < smallest_angle)
            throw Error(labels[i], "the profile folds back on itself at " + text(ahead.point) +
                                       ", expected an angle between the two parts");
    }
}

void check_area(std::span<const ProfilePiece> pieces, const std::string& label, double size) {
    double area = 0.0;
    for (const ProfilePiece& piece : pieces)
        area += 0.5 * (piece.from.x() + piece.to.x()) * (piece.to.y() - piece.from.y());
    if (!(area > 1e-9 * square(size)))
        throw Error(label, "the profile encloses no volume, expected a body between its two ends");
}

}  // namespace

void check_path(std::span<const ProfileSegment> segments, std::span<const std::string> labels) {
    if (segments.empty()) throw Error("profile", "found no segments, expected at least one");
    const Vec2 extent = path_extent(segments);
    const double size = extent.maxCoeff();
    if (extent.allFinite()) check_extent(extent, labels.front());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const CurveJet start = evaluate(segments[i], 0.0);
        const CurveJet middle = evaluate(segments[i], 0.5);
        const CurveJet end = evaluate(segments[i], 1.0);
        if (!(start.point.allFinite() && middle.point.allFinite() && end.point.allFinite() &&
              middle.first.allFinite()))
            throw Error(labels[i], "found a coordinate that is not finite, expected a number");
        if (!((middle.point - start.point).norm() > touch_tolerance * size))
            throw Error(labels[i], "the segment at " + text(start.point) +
                                       " has no length, expected another end");
        if (i == 0) continue;
        const Vec2 previous = evaluate(segments[i - 1], 1.0).point;
        if (!((start.point - previous).norm() <= join_tolerance * size))
            throw Error(labels[i], "the segment starts at " + text(start.point) +
                                       ", expected it to join the one before at " + text(previous));
    }
    const Vec2 bottom = evaluate(segments.front(), 0.0).point;
    const Vec2 top = evaluate(segments.back(), 1.0).point;
    if (std::abs(bottom.x()) > join_tolerance * size)
        throw Error(labels.front(), "the profile is open: it starts at " + text(bottom) +
                                        ", expected a start on the axis");
    if (std::abs(top.x()) > join_tolerance * size)
        throw Error(labels.back(), "the profile is open: it ends at " + text(top) +
                                       ", expected an end on the axis");
    if (!(top.y() - bottom.y() > join_tolerance * size))
        throw Error(labels.back(), "the profile runs from " + text(bottom) + " to " + text(top) +
                                       ", expected it to end above its start");
}

void check_shape(std::span<const ProfileSegment> segments, std::span<const std::string> labels,
                 const PieceTree& tree, double size) {
    check_axis(segments, labels, tree.pieces(), touch_tolerance * size);
    check_folds(segments, labels);
    if (const auto meeting = tree.find_meeting(segments, touch_tolerance * size))
        throw Error(labels[meeting->second_segment],
                    "the profile crosses or touches itself at " + text(meeting->point) +
                        ", where it passed before (" + labels[meeting->first_segment] +
                        "), expected a path that meets itself nowhere");
    check_area(tree.pieces(), labels.front(), size);
}

}  // namespace dem::shapegen
