// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/arc_spline.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/profile/plane.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

constexpr double smallest_turn = 1e-13;          // [rad]
constexpr double largest_turn = pi / 2.0 / 128;  // of a biarc: 256 arcs per quarter [rad]
constexpr double spline_tolerance = 2e-8;        // of l
constexpr double largest_radius = 2500.0;        // of l: that of a crown, l / 4e-4 rad

struct Biarc {
    SupportPiece first, second;
    Vec2 joint_normal;
};

SupportPiece circle(const Vec2& point, const Vec2& normal, double radius) {
    return {point.x() - radius * normal.x(), point.y() - radius * normal.y(), radius, radius};
}

/// With A, n_A and B, n_B at the ends and n_J the normal of the chord, the radii solve
/// r_1 (n_J - n_A) + r_2 (n_B - n_J) = B - A.
Biarc biarc(const SupportLink& link) {
    const Vec2 chord = link.to - link.from;
    const Vec2 joint = Vec2(chord.y(), -chord.x()).normalized();
    const Vec2 d1 = joint - link.first_normal;
    const Vec2 d2 = link.last_normal - joint;
    const double half1 = math::sin(0.5 * turn(link.first_normal, joint));
    const double half2 = math::sin(0.5 * turn(joint, link.last_normal));
    const double cos1 = std::sqrt(1.0 - half1 * half1);
    const double cos2 = std::sqrt(1.0 - half2 * half2);
    const double ratio = square(half1 / half2);
    double r1 = chord.norm() / (2.0 * half1 * cos1 + 2.0 * ratio * half2 * cos2);
    double r2 = ratio * r1;
    // The differences of nearby normals carry rounding errors that large radii magnify: correct the
    // radii for the normals as they are stored.
    const Vec2 rest = chord - r1 * d1 - r2 * d2;
    const double determinant = cross(d1, d2);
    const double change1 = cross(rest, d2) / determinant;
    const double change2 = cross(d1, rest) / determinant;
    if (std::abs(change1) < 1e-3 * r1 && std::abs(change2) < 1e-3 * r2) {
        r1 += change1;
        r2 += change2;
    }
    return {circle(link.from, link.first_normal, r1), circle(link.to, link.last_normal, r2), joint};
}

bool turns_left_throughout(const SupportLink& link) {
    const Vec2 chord = link.to - link.from;
    const Vec2 joint = Vec2(chord.y(), -chord.x()).normalized();
    return turn(link.first_normal, joint) > smallest_turn &&
           turn(joint, link.last_normal) > smallest_turn;
}

/// Distance between the curve and the biarc that stands for it, along the curve's normals.
double spline_error(const ProfileSegment& segment, const SupportLink& link, const Biarc& arcs) {
    double error = 0.0;
    for (const double share : {0.2, 0.4, 0.6, 0.8}) {
        const CurveJet jet = evaluate(segment, link.t0 + share * (link.t1 - link.t0));
        const Vec2 normal = Vec2(jet.first.y(), -jet.first.x()).normalized();
        const SupportPiece& arc = turn(normal, arcs.joint_normal) > 0.0 ? arcs.first : arcs.second;
        const Vec2 off = jet.point - Vec2(arc.center_r, arc.center_z);
        error = std::max(error, std::abs(normal.dot(off) - arc.a));
    }
    return error;
}

}  // namespace

double direction_measure(const Vec2& normal) {
    return normal.y() / (std::max(normal.x(), 0.0) + std::abs(normal.y()));
}

void SupportPieces::append(const SupportPiece& piece, const Vec2& last_normal) {
    const double end = direction_measure(last_normal);
    if (end <= (ends_.empty() ? -1.0 : ends_.back())) return;
    pieces_.push_back(piece);
    ends_.push_back(end);
}

void SupportPieces::append_corner(const Vec2& point, const Vec2& last_normal) {
    append({point.x(), point.y(), 0.0, 0.0}, last_normal);
}

void SupportPieces::append_biarc(const SupportLink& link) {
    if (!turns_left_throughout(link)) return;
    const Biarc arcs = biarc(link);
    append(arcs.first, arcs.joint_normal);
    append(arcs.second, link.last_normal);
}

void SupportPieces::append_end_face(const SupportLink& link) {
    const bool is_bottom = link.from.x() == 0.0;
    const Vec2& rim = is_bottom ? link.to : link.from;
    const Vec2& normal = is_bottom ? link.last_normal : link.first_normal;
    const double radius = rim.x() / normal.x();
    append({0.0, rim.y() - radius * normal.y(), radius, radius},
           is_bottom ? normal : Vec2(0.0, 1.0));
}

void SupportPieces::append_curve(const ProfileSegment& segment, const SupportLink& link) {
    if (const auto* arc = std::get_if<EllipseArc>(&segment)) {
        append({arc->center.x(), arc->center.y(), arc->a, arc->b}, link.last_normal);
    } else {
        append_spline(segment, link, 40);
    }
}

void SupportPieces::append_spline(const ProfileSegment& segment, const SupportLink& link,
                                  int depth) {
    const double angle = turn(link.first_normal, link.last_normal);
    if (angle <= smallest_turn) return;
    const bool is_flat = (link.to - link.from).norm() > angle * largest_radius * size_;
    if (depth == 0 || is_flat ||
        (angle <= largest_turn && turns_left_throughout(link) &&
         spline_error(segment, link, biarc(link)) <= spline_tolerance * size_)) {
        append_biarc(link);
        return;
    }
    const Vec2 normal = (link.first_normal + link.last_normal).normalized();
    SupportLink lower = link;
    SupportLink upper = link;
    lower.t1 = upper.t0 = parameter_of_normal(segment, normal, link.t0, link.t1);
    const CurveJet jet = evaluate(segment, lower.t1);
    lower.to = upper.from = jet.point;
    lower.last_normal = upper.first_normal = Vec2(jet.first.y(), -jet.first.x()).normalized();
    append_spline(segment, lower, depth - 1);
    append_spline(segment, upper, depth - 1);
}

}  // namespace dem::shapegen
