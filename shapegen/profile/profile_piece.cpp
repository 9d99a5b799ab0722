// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_piece.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/profile/plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem::shapegen {
namespace {

constexpr double largest_turn = 0.1;  // [rad]
constexpr double shortest_part = 1e-4;

const EllipseArc* as_circle(const ProfileSegment& segment) {
    const auto* arc = std::get_if<EllipseArc>(&segment);
    return arc && arc->a == arc->b ? arc : nullptr;
}

/// How far a curve can leave its chord: by its curvature (the arc is at most 10 % longer than the
/// chord while it turns by less than 0.1 rad), and by staying in the cone of its tangents.
double bulge_bound(double chord, double curvature, double turn) {
    const auto [sine, cosine] = math::sin_cos(std::min(turn, 1.0));
    const double by_turn = 0.5 * chord * sine / cosine;
    const double by_curvature = 0.125 * curvature * square(1.1 * chord);
    return std::min(by_turn, by_curvature);
}

double largest_curvature(const ProfilePiece& piece) {
    return std::max(std::abs(piece.min_curvature), std::abs(piece.max_curvature));
}

void append_circle(const ProfileSegment& segment, const EllipseArc& arc, std::uint32_t index,
                   std::vector<ProfilePiece>& pieces) {
    const double sweep = std::abs(arc.end - arc.start);
    const auto count = static_cast<int>(std::ceil(sweep / largest_turn));
    const double curvature = (arc.end > arc.start ? 1.0 : -1.0) / arc.a;
    const double turn = sweep / count;
    for (int i = 0; i < count; ++i) {
        const double t0 = static_cast<double>(i) / count;
        const double t1 = static_cast<double>(i + 1) / count;
        const CurveJet from = evaluate(segment, t0);
        const CurveJet to = evaluate(segment, t1);
        pieces.push_back({from.point, to.point, from.first, to.first, t0, t1, index,
                          arc.a * (1.0 - math::cos(0.5 * turn)) * (1.0 + 1e-9), curvature,
                          curvature, turn});
    }
}

void append_curve(const ProfileSegment& segment, std::uint32_t index, double t0, double t1,
                  int depth, std::vector<ProfilePiece>& pieces) {
    constexpr int samples = 5;
    std::array<CurveJet, samples> jets;
    double turn = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < samples; ++i) {
        jets[i] = evaluate(segment, t0 + (t1 - t0) * static_cast<double>(i) / (samples - 1));
        const double curvature = signed_curvature(jets[i]);
        low = std::min(low, curvature);
        high = std::max(high, curvature);
        if (i > 0) turn += angle_between(jets[i - 1].first, jets[i].first);
    }
    if (turn > largest_turn && depth > 0) {
        const double middle = 0.5 * (t0 + t1);
        append_curve(segment, index, t0, middle, depth - 1, pieces);
        append_curve(segment, index, middle, t1, depth - 1, pieces);
        return;
    }
    const double margin = 0.5 * (high - low);
    ProfilePiece piece{jets.front().point,
                       jets.back().point,
                       jets.front().first,
                       jets.back().first,
                       t0,
                       t1,
                       index,
                       0.0,
                       low - margin,
                       high + margin,
                       1.25 * turn + 1e-12};
    const double chord = (piece.to - piece.from).norm();
    piece.bulge = bulge_bound(chord, largest_curvature(piece), piece.turn);
    pieces.push_back(piece);
}

/// With N the left normal of the curve, (c - x) . T grows along the arc at the rate
/// 1 - kappa (x - c) . N: where kappa (x - c) . N stays below 1 the distance from x has one
/// minimum, where it stays above (x lies beyond the centers of curvature) the minimum is at an end.
struct Range {
    double low, high;
};
Range curvature_times_height(const ProfilePiece& piece, const Vec2& x) {
    const Vec2 chord = (piece.to - piece.from).normalized();
    const double across =
        chord.x() * (x.y() - piece.from.y()) - chord.y() * (x.x() - piece.from.x());
    const double along =
        std::max(std::abs(chord.dot(x - piece.from)), std::abs(chord.dot(x - piece.to))) +
        piece.bulge;
    // The normals tilt against that of the chord by at most the turn.
    const double shrink = across * (1.0 - math::cos(piece.turn));
    const double margin = piece.bulge + math::sin(std::min(piece.turn, 0.5 * pi)) * along;
    const double low = across - std::max(shrink, 0.0) - margin;
    const double high = across - std::min(shrink, 0.0) + margin;
    const auto [lowest, highest] =
        std::minmax({low * piece.min_curvature, low * piece.max_curvature,
                     high * piece.min_curvature, high * piece.max_curvature});
    return {lowest, highest};
}

void improve(ProfilePoint& best, const Vec2& point, const ProfilePiece& piece, double t,
             double distance) {
    if (distance < best.distance) best = {point, piece.segment, t, distance};
}

/// Bracketed Newton for (c - x) . c' = 0. Where that does not rise through zero inside the piece
/// the minimum is at an end, which has been looked at already.
void improve_by_newton(const ProfileSegment& segment, const ProfilePiece& piece, const Vec2& x,
                       ProfilePoint& best) {
    if ((piece.from - x).dot(piece.first_tangent) >= 0.0 ||
        (piece.to - x).dot(piece.last_tangent) <= 0.0)
        return;
    double low = piece.t0;
    double high = piece.t1;
    const Vec2 chord = piece.to - piece.from;
    double t = low + (high - low) *
                         std::clamp(chord.dot(x - piece.from) / chord.squaredNorm(), 0.05, 0.95);
    CurveJet jet = evaluate(segment, t);
    for (int iteration = 0; iteration < 80; ++iteration) {
        const Vec2 away = jet.point - x;
        const double value = away.dot(jet.first);
        if (value == 0.0) break;
        (value > 0.0 ? high : low) = t;
        const double slope = jet.first.squaredNorm() + away.dot(jet.second);
        double next = t - value / slope;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const double step = std::abs(next - t);
        t = next;
        jet = evaluate(segment, t);
        if (step <= 1e-13 || high - low <= 1e-15) break;
    }
    improve(best, jet.point, piece, t, (jet.point - x).norm());
}

void improve_on_curve(const ProfileSegment& segment, const ProfilePiece& piece, const Vec2& x,
                      double shortest, ProfilePoint& best) {
    if (distance_to_chord(x, piece.from, piece.to) - piece.bulge >= best.distance) return;
    const Range range = curvature_times_height(piece, x);
    if (range.low > 1.0) return;
    // Below `shortest` the distance hardly varies over the piece even where its minimum is flat
    // (near a center of curvature): any local minimum is exact to shortest^3.
    if (range.high < 1.0 || (piece.to - piece.from).norm() < shortest) {
        improve_by_newton(segment, piece, x, best);
        return;
    }
    auto [first, second] = halves(segment, piece);
    improve(best, first.to, first, first.t1, (first.to - x).norm());
    if ((second.to - x).squaredNorm() < (first.from - x).squaredNorm()) std::swap(first, second);
    improve_on_curve(segment, first, x, shortest, best);
    improve_on_curve(segment, second, x, shortest, best);
}

void improve_on_line(const ProfilePiece& piece, const Vec2& x, ProfilePoint& best) {
    const Vec2 along = piece.to - piece.from;
    const double t = std::clamp(along.dot(x - piece.from) / along.squaredNorm(), 0.0, 1.0);
    const Vec2 point = t < 1.0 ? Vec2(piece.from + t * along) : piece.to;
    improve(best, point, piece, t, (point - x).norm());
}

void improve_on_circle(const ProfilePiece& piece, const EllipseArc& arc, const Vec2& x,
                       ProfilePoint& best) {
    const Vec2 spoke = x - arc.center;
    const double reach = spoke.norm();
    const double sweep = arc.end - arc.start;
    const double middle = arc.start + 0.5 * (piece.t0 + piece.t1) * sweep;
    const double half = 0.5 * std::abs(sweep) * (piece.t1 - piece.t0);
    const double off =
        reach > 0.0 ? std::remainder(math::atan2(spoke.y(), spoke.x()) - middle, 2.0 * pi) : 0.0;
    if (std::abs(off) <= half) {
        const Vec2 radial =
            reach > 0.0 ? Vec2(spoke / reach) : Vec2(math::cos(middle), math::sin(middle));
        const double t = std::clamp((middle + off - arc.start) / sweep, piece.t0, piece.t1);
        improve(best, arc.center + arc.a * radial, piece, t, std::abs(reach - arc.a));
        return;
    }
    improve(best, piece.from, piece, piece.t0, (piece.from - x).norm());
    improve(best, piece.to, piece, piece.t1, (piece.to - x).norm());
}

}  // namespace

double distance_to_chord(const Vec2& x, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(along.dot(x - a) / length2, 0.0, 1.0) : 0.0;
    return (a + t * along - x).norm();
}

void append_pieces(const ProfileSegment& segment, std::uint32_t index,
                   std::vector<ProfilePiece>& pieces) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) {
        const Vec2 along = line->to - line->from;
        pieces.push_back({line->from, line->to, along, along, 0.0, 1.0, index, 0.0, 0.0, 0.0, 0.0});
    } else if (const EllipseArc* arc = as_circle(segment)) {
        append_circle(segment, *arc, index, pieces);
    } else {
        constexpr int parts = 8;
        for (int i = 0; i < parts; ++i)
            append_curve(segment, index, static_cast<double>(i) / parts,
                         static_cast<double>(i + 1) / parts, 40, pieces);
    }
}

std::array<ProfilePiece, 2> halves(const ProfileSegment& segment, const ProfilePiece& piece) {
    const double middle = 0.5 * (piece.t0 + piece.t1);
    const CurveJet jet = evaluate(segment, middle);
    std::array<ProfilePiece, 2> parts{piece, piece};
    parts[0].to = parts[1].from = jet.point;
    parts[0].last_tangent = parts[1].first_tangent = jet.first;
    parts[0].t1 = parts[1].t0 = middle;
    const double curvature = largest_curvature(piece);
    for (ProfilePiece& part : parts) {
        const double chord = (part.to - part.from).norm();
        part.turn = std::min(piece.turn, 1.1 * curvature * chord);
        part.bulge = bulge_bound(chord, curvature, part.turn);
    }
    return parts;
}

void improve_nearest(const ProfileSegment& segment, const ProfilePiece& piece, const Vec2& x,
                     ProfilePoint& best) {
    if (std::holds_alternative<LineSegment>(segment)) {
        improve_on_line(piece, x, best);
    } else if (const EllipseArc* arc = as_circle(segment)) {
        improve_on_circle(piece, *arc, x, best);
    } else {
        const double shortest = shortest_part * (piece.to - piece.from).norm();
        improve(best, piece.from, piece, piece.t0, (piece.from - x).norm());
        improve(best, piece.to, piece, piece.t1, (piece.to - x).norm());
        improve_on_curve(segment, piece, x, shortest, best);
    }
}

double largest_along(const ProfileSegment& segment, const ProfilePiece& piece,
                     const Vec2& direction) {
    const double at_ends = std::max(direction.dot(piece.from), direction.dot(piece.to));
    double low = piece.t0;
    double high = piece.t1;
    if (direction.dot(evaluate(segment, low).first) <= 0.0 ||
        direction.dot(evaluate(segment, high).first) >= 0.0)
        return at_ends;
    for (int i = 0; i < 60 && high - low > 1e-16; ++i) {
        const double middle = 0.5 * (low + high);
        (direction.dot(evaluate(segment, middle).first) > 0.0 ? low : high) = middle;
    }
    return std::max(at_ends, direction.dot(evaluate(segment, 0.5 * (low + high)).point));
}

}  // namespace dem::shapegen
