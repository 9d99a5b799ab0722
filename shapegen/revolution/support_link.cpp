// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/support_link.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

/// A flat turns by twice this angle [rad] ...
constexpr double crown_half_angle = 2e-4;
/// ... unless it is so long that its middle would move by more than this part of l: a crown of
/// half-angle d on a length L rises by L d / 4.
constexpr double largest_rise = 3e-5;
/// Normals that differ by less are the same [rad].
constexpr double same_angle = 1e-12;

Vec2 rotated(const Vec2& v, double angle) {
    const double c = math::cos(angle);
    const double s = math::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Vec2 right_normal(const Vec2& along) {
    return Vec2(along.y(), -along.x()).normalized();
}

SupportLink flat_link(const Vec2& from, const Vec2& to) {
    const Vec2 normal = right_normal(to - from);
    return {from, to, normal, normal, std::nullopt};
}

/// A curve that turns by less than a crown counts as flat: its radius is beyond what a crown gives.
SupportLink link_of(const Profile& profile, std::size_t k) {
    const ProfileSegment& segment = profile.segments()[k];
    const CurveJet start = evaluate(segment, 0.0);
    const CurveJet end = evaluate(segment, 1.0);
    const Vec2 first = right_normal(start.first);
    const Vec2 last = right_normal(end.first);
    if (std::holds_alternative<LineSegment>(segment) ||
        std::abs(turn(first, last)) <= 2.0 * crown_half_angle)
        return flat_link(start.point, end.point);
    return {start.point, end.point, first, last, k, 0.0, 1.0};
}

/// Appends a flat and merges it with those before it that it continues straight on or, by rounding,
/// bends back from: what remains is the hull of the run.
void append_flat(SupportLink link, double size, std::vector<SupportLink>& links) {
    while (!links.empty() && links.back().is_flat()) {
        const Vec2& from = links.back().from;
        const Vec2 normal = right_normal(link.to - from);
        if (normal.dot(link.from - from) > 1e-12 * size) break;
        link = flat_link(from, link.to);
        links.pop_back();
    }
    links.push_back(link);
}

double half_angle(const SupportLink& flat, double size) {
    const double length = (flat.to - flat.from).norm() * (flat.is_end_face ? 2.0 : 1.0);
    return std::min(crown_half_angle, 4.0 * largest_rise * size / length);
}

void trim_end(const Profile& profile, SupportLink& link, const Vec2& normal) {
    const ProfileSegment& segment = profile.segments()[*link.segment];
    const double most = 0.5 * turn(link.first_normal, link.last_normal);
    const double wanted = turn(normal, link.last_normal);
    const Vec2 end = wanted < most ? normal : rotated(link.last_normal, -most);
    link.t1 = parameter_of_normal(segment, end, link.t0, link.t1);
    link.to = evaluate(segment, link.t1).point;
    link.last_normal = end;
}

void trim_start(const Profile& profile, SupportLink& link, const Vec2& normal) {
    const ProfileSegment& segment = profile.segments()[*link.segment];
    const double most = 0.5 * turn(link.first_normal, link.last_normal);
    const double wanted = turn(link.first_normal, normal);
    const Vec2 start = wanted < most ? normal : rotated(link.first_normal, most);
    link.t0 = parameter_of_normal(segment, start, link.t0, link.t1);
    link.from = evaluate(segment, link.t0).point;
    link.first_normal = start;
}

/// Gives two flats that meet in a corner their share of its fan.
void crown_at_corner(SupportLink& before, SupportLink& after, double size) {
    const double fan = turn(before.last_normal, after.first_normal);
    before.last_normal = rotated(before.last_normal, std::min(half_angle(before, size), 0.5 * fan));
    after.first_normal = rotated(after.first_normal, -std::min(half_angle(after, size), 0.5 * fan));
}

void crown_after_curve(const Profile& profile, SupportLink& curve, SupportLink& flat, double size) {
    const double angle = half_angle(flat, size);
    flat.first_normal = rotated(flat.first_normal, -angle);
    if (turn(curve.last_normal, flat.first_normal) >= 0.0) return;  // the corner has room
    trim_end(profile, curve, flat.first_normal);
    flat.from = curve.to;
    flat.first_normal = curve.last_normal;
}

void crown_before_curve(const Profile& profile, SupportLink& flat, SupportLink& curve,
                        double size) {
    const double angle = half_angle(flat, size);
    flat.last_normal = rotated(flat.last_normal, angle);
    if (turn(flat.last_normal, curve.first_normal) >= 0.0) return;
    trim_start(profile, curve, flat.last_normal);
    flat.to = curve.from;
    flat.last_normal = curve.first_normal;
}

/// Two curves that meet in a dent (of rounding depth) are cut back and joined by a crowned flat.
SupportLink bridge(const Profile& profile, SupportLink& before, SupportLink& after) {
    trim_end(profile, before, rotated(after.first_normal, -crown_half_angle));
    trim_start(profile, after, rotated(after.first_normal, crown_half_angle));
    return {before.to, after.from, before.last_normal, after.first_normal, std::nullopt};
}

/// The poles' normals are exact, and the ends there lie on the axis.
void settle_poles(std::vector<SupportLink>& links, double size) {
    constexpr double rounding = 1e-9;
    SupportLink& bottom = links.front();
    SupportLink& top = links.back();
    const double bottom_turn = turn(Vec2(0.0, -1.0), bottom.first_normal);
    const double top_turn = turn(top.last_normal, Vec2(0.0, 1.0));
    bottom.from.x() = top.to.x() = 0.0;
    bottom.is_end_face = bottom.is_flat() && bottom_turn < 2.0 * crown_half_angle;
    top.is_end_face = top.is_flat() && top_turn < 2.0 * crown_half_angle;
    if (!bottom.is_flat() && bottom_turn < rounding) bottom.first_normal = Vec2(0.0, -1.0);
    if (!top.is_flat() && top_turn < rounding) top.last_normal = Vec2(0.0, 1.0);
    // A tip has all the room a crown needs.
    if (bottom.is_flat() && !bottom.is_end_face)
        bottom.first_normal = rotated(bottom.first_normal, -half_angle(bottom, size));
    if (top.is_flat() && !top.is_end_face)
        top.last_normal = rotated(top.last_normal, half_angle(top, size));
}

}  // namespace

double turn(const Vec2& from, const Vec2& to) {
    return math::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

double parameter_of_normal(const ProfileSegment& segment, const Vec2& normal, double t0,
                           double t1) {
    if (const auto* arc = std::get_if<EllipseArc>(&segment)) {
        const double phi = math::atan2(arc->b * normal.y(), arc->a * normal.x());
        const double middle = 0.5 * (arc->start + arc->end);
        const double t = 0.5 + std::remainder(phi - middle, 2.0 * pi) / (arc->end - arc->start);
        return std::clamp(t, t0, t1);
    }
    while (t1 - t0 > 1e-15) {
        const double middle = 0.5 * (t0 + t1);
        if (middle == t0 || middle == t1) break;
        (turn(right_normal(evaluate(segment, middle).first), normal) > 0.0 ? t0 : t1) = middle;
    }
    return 0.5 * (t0 + t1);
}

std::vector<SupportLink> support_links(const Profile& profile) {
    const double size = profile.major_axis_length();
    std::vector<SupportLink> plain;
    for (std::size_t k = 0; k < profile.segments().size(); ++k) {
        const SupportLink link = link_of(profile, k);
        if (link.is_flat()) {
            append_flat(link, size, plain);
        } else {
            plain.push_back(link);
        }
    }
    settle_poles(plain, size);

    std::vector<SupportLink> links{plain.front()};
    for (std::size_t i = 1; i < plain.size(); ++i) {
        SupportLink& before = links.back();
        SupportLink after = plain[i];
        if (before.is_flat() && after.is_flat()) {
            crown_at_corner(before, after, size);
        } else if (after.is_flat()) {
            crown_after_curve(profile, before, after, size);
        } else if (before.is_flat()) {
            crown_before_curve(profile, before, after, size);
        } else if (turn(before.last_normal, after.first_normal) < -same_angle) {
            const SupportLink joining = bridge(profile, before, after);
            links.push_back(joining);
        }
        links.push_back(after);
    }
    return links;
}

}  // namespace dem::shapegen
