// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/arcs.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/profile/plane.hpp"
#include "shapegen/profile/profile_curves.hpp"

#include <cmath>
#include <limits>

namespace dem::shapegen {
namespace {

double angle_of(const Vec2& v) {
    return math::atan2(v.y(), v.x());
}

/// The line or circle on which the centers of all arcs of one radius tangent to a segment lie.
struct OffsetLocus {
    Vec2 point;      ///< of the line, or the center
    Vec2 direction;  ///< of the line; zero for a circle
    double radius = 0.0;

    bool is_line() const { return direction != Vec2::Zero(); }
    Vec2 foot(const Vec2& x) const {
        if (is_line()) return point + direction.dot(x - point) * direction;
        return point + radius * (x - point).normalized();
    }
};

/// The segment moved to its left by `offset` (to the right when negative).
std::optional<OffsetLocus> offset_locus(const ProfileSegment& segment, double offset) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) {
        const Vec2 along = (line->to - line->from).normalized();
        return OffsetLocus{line->from + offset * Vec2(-along.y(), along.x()), along};
    }
    const auto* arc = std::get_if<EllipseArc>(&segment);
    if (arc == nullptr || arc->a != arc->b) return std::nullopt;
    const double radius = arc->a - (arc->end > arc->start ? offset : -offset);
    if (radius <= 0.0) return std::nullopt;
    return OffsetLocus{arc->center, Vec2::Zero(), radius};
}

std::vector<Vec2> line_meets_circle(const OffsetLocus& line, const OffsetLocus& circle) {
    const Vec2 foot = line.foot(circle.point);
    const double half2 = square(circle.radius) - (foot - circle.point).squaredNorm();
    if (half2 < 0.0) return {};
    const Vec2 half = std::sqrt(half2) * line.direction;
    return {foot + half, foot - half};
}

std::vector<Vec2> circles_meet(const OffsetLocus& a, const OffsetLocus& b) {
    const Vec2 between = b.point - a.point;
    const double distance = between.norm();
    if (distance == 0.0) return {};
    const double along = 0.5 * (distance + (square(a.radius) - square(b.radius)) / distance);
    const double half2 = square(a.radius) - square(along);
    if (half2 < 0.0) return {};
    const Vec2 unit = between / distance;
    const Vec2 across = std::sqrt(half2) * Vec2(-unit.y(), unit.x());
    return {a.point + along * unit + across, a.point + along * unit - across};
}

std::vector<Vec2> common_points(const OffsetLocus& a, const OffsetLocus& b) {
    if (a.is_line() && b.is_line()) {
        const double sine = cross(a.direction, b.direction);
        if (std::abs(sine) < 1e-12) return {};
        return {a.point + cross(b.point - a.point, b.direction) / sine * a.direction};
    }
    if (a.is_line()) return line_meets_circle(a, b);
    if (b.is_line()) return line_meets_circle(b, a);
    return circles_meet(a, b);
}

/// Parameter of the point of a line or circular arc next to x; outside [0, 1] beyond its ends.
double parameter_of(const ProfileSegment& segment, const Vec2& x) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) {
        const Vec2 along = line->to - line->from;
        return along.dot(x - line->from) / along.squaredNorm();
    }
    const auto& arc = std::get<EllipseArc>(segment);
    const double middle = 0.5 * (arc.start + arc.end);
    return 0.5 +
           std::remainder(angle_of(x - arc.center) - middle, 2.0 * pi) / (arc.end - arc.start);
}

ProfileSegment part_of(const ProfileSegment& segment, double t0, double t1, const Vec2& from,
                       const Vec2& to) {
    if (std::holds_alternative<LineSegment>(segment)) return LineSegment{from, to};
    EllipseArc arc = std::get<EllipseArc>(segment);
    const double sweep = arc.end - arc.start;
    const double start = arc.start;
    if (t0 > 0.0) arc.start = start + t0 * sweep;
    if (t1 < 1.0) arc.end = start + t1 * sweep;
    return arc;
}

}  // namespace

std::optional<EllipseArc> arc_between(const Vec2& from, const Vec2& to, double a, double b,
                                      ArcSense sense) {
    // On the unit circle of the scaled plane.
    const Vec2 p(from.x() / a, from.y() / b);
    const Vec2 q(to.x() / a, to.y() / b);
    const Vec2 chord = q - p;
    const double half = 0.5 * chord.norm();
    // A half circle may be asked for by rounded numbers.
    if (half == 0.0 || half > 1.0 + 1e-9) return std::nullopt;
    const double height = std::sqrt(std::max(0.0, 1.0 - half * half));
    const Vec2 left = Vec2(-chord.y(), chord.x()) / (2.0 * half);
    const bool center_is_left = sense.turns_left != sense.is_large;
    const Vec2 center = 0.5 * (p + q) + (center_is_left ? height : -height) * left;
    EllipseArc arc{Vec2(center.x() * a, center.y() * b), a, b, angle_of(p - center),
                   angle_of(q - center)};
    if (sense.turns_left && arc.end <= arc.start) arc.end += 2.0 * pi;
    if (!sense.turns_left && arc.end >= arc.start) arc.end -= 2.0 * pi;
    return arc;
}

std::optional<EllipseArc> arc_through(const Vec2& from, const Vec2& middle, const Vec2& to) {
    const Vec2 u = middle - from;
    const Vec2 v = to - from;
    const double twice_area = cross(u, v);
    if (std::abs(twice_area) <= 1e-12 * u.norm() * v.norm()) return std::nullopt;
    const Vec2 offset = Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                             u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                        (2.0 * twice_area);
    const double radius = offset.norm();
    const Vec2 center = from + offset;
    EllipseArc arc{center, radius, radius, angle_of(from - center), angle_of(to - center)};
    if (twice_area > 0.0 && arc.end <= arc.start) arc.end += 2.0 * pi;
    if (twice_area < 0.0 && arc.end >= arc.start) arc.end -= 2.0 * pi;
    return arc;
}

std::optional<Fillet> fillet(const ProfileSegment& before, const ProfileSegment& after,
                             double radius) {
    const Vec2 in = evaluate(before, 1.0).first;
    const CurveJet out = evaluate(after, 0.0);
    const double sine = cross(in.normalized(), out.first.normalized());
    if (std::abs(sine) < 1e-9) return std::nullopt;
    const double offset = sine > 0.0 ? radius : -radius;
    const auto locus_before = offset_locus(before, offset);
    const auto locus_after = offset_locus(after, offset);
    if (!locus_before || !locus_after) return std::nullopt;
    std::optional<Fillet> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& center : common_points(*locus_before, *locus_after)) {
        const double t_before = parameter_of(before, center);
        const double t_after = parameter_of(after, center);
        const double distance = (center - out.point).norm();
        if (!(t_before > 0.0 && t_before < 1.0 && t_after > 0.0 && t_after < 1.0) ||
            distance >= nearest)
            continue;
        nearest = distance;
        const Vec2 first = evaluate(before, t_before).point;
        const Vec2 last = evaluate(after, t_after).point;
        const double start = angle_of(first - center);
        const double sweep = std::remainder(angle_of(last - center) - start, 2.0 * pi);
        best = Fillet{part_of(before, 0.0, t_before, evaluate(before, 0.0).point, first),
                      EllipseArc{center, radius, radius, start, start + sweep},
                      part_of(after, t_after, 1.0, last, evaluate(after, 1.0).point)};
    }
    return best;
}

std::vector<ProfileSegment> cubic_spline(std::span<const Vec2> points,
                                         const std::optional<Vec2>& first_tangent,
                                         const std::optional<Vec2>& last_tangent) {
    const std::size_t n = points.size();
    std::vector<double> step(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) step[i] = (points[i + 1] - points[i]).norm();
    // Tangents m_i of equal second derivative at the joints: a tridiagonal system, solved in place.
    std::vector<double> diagonal(n, 1.0);
    std::vector<double> upper(n, 0.0);
    std::vector<Vec2> tangent(n);
    const auto slope = [&](std::size_t i) -> Vec2 { return (points[i + 1] - points[i]) / step[i]; };
    if (!first_tangent) upper[0] = 0.5;
    tangent[0] = first_tangent ? *first_tangent : Vec2(1.5 * slope(0));
    for (std::size_t i = 1; i < n; ++i) {
        const bool is_last = i + 1 == n;
        const double lower = is_last ? (last_tangent ? 0.0 : 0.5) : 1.0 / step[i - 1];
        const double middle = is_last ? 1.0 : 2.0 * (1.0 / step[i - 1] + 1.0 / step[i]);
        const Vec2 right = is_last ? (last_tangent ? *last_tangent : Vec2(1.5 * slope(i - 1)))
                                   : Vec2(3.0 * (slope(i - 1) / step[i - 1] + slope(i) / step[i]));
        upper[i] = is_last ? 0.0 : 1.0 / step[i];
        const double factor = lower / diagonal[i - 1];
        diagonal[i] = middle - factor * upper[i - 1];
        tangent[i] = right - factor * tangent[i - 1];
    }
    for (std::size_t i = n; i-- > 0;)
        tangent[i] =
            (i + 1 < n ? Vec2(tangent[i] - upper[i] * tangent[i + 1]) : tangent[i]) / diagonal[i];
    std::vector<ProfileSegment> spline;
    for (std::size_t i = 0; i + 1 < n; ++i)
        spline.push_back(
            cubic_bezier({points[i], points[i] + step[i] / 3.0 * tangent[i],
                          points[i + 1] - step[i] / 3.0 * tangent[i + 1], points[i + 1]}));
    return spline;
}

}  // namespace dem::shapegen
