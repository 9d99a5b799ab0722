// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/meshes/ball_touch.hpp"

#include <algorithm>
#include <cmath>

// A ball touches where its center is nearer to the surface than its radius and no way along the
// surface leads nearer: over a face; in front of a bulging edge or corner, where the direction to
// the center lies between the normals of the faces there; at a rim. Flat and hollow edges are never
// nearest by themselves, so that every place is counted once, and neighbors in one plane are one
// plane. By rounding a center over an edge may seem to be beside both of its faces: the conditions
// give way by `rounding`, and touches of one direction are one.

namespace dem::runtime {

namespace {

/// Nobody touches a side for the first time with a center nearer than this, in radii.
constexpr double first_touch = 0.9;

}  // namespace

double BallTouches::add(std::uint32_t t) {
    const Vec3& a = mesh_.corner(t, 0);
    const TrianglePoint nearest =
        nearest_on_triangle(a, mesh_.corner(t, 1), mesh_.corner(t, 2), center_);
    const double distance = (center_ - nearest.point).norm();
    if (!(distance < reach_)) return distance;
    const Vec3& n = mesh_.normals[t];
    const double height = (center_ - a).dot(n);
    const bool is_front = height >= 0.0;
    const PatchSide side = 2 * mesh_.patches[t] + (is_front ? 0U : 1U);
    const Vec3 normal = is_front ? n : Vec3(-n);
    const double overlap = radius_ - std::abs(height);
    // A center that has come through keeps its side; a ball that comes from the other side touches
    // it far from its center first.
    const bool is_from_behind = !history_.knows(side) && history_.knows(other_side(side));
    const bool has_come_through = is_from_behind && distance < 0.5 * radius_;
    if (is_from_behind && !has_come_through && distance < first_touch * radius_) is_lost_ = true;
    if (nearest.part == TrianglePoint::inside) {
        if (has_come_through)
            keep(radius_ + std::abs(height), -normal, other_side(side), false);
        else
            keep(overlap, normal, side, false);
        return distance;
    }
    if (has_come_through) {
        if (is_nearest(t, nearest))
            keep(radius_ + std::abs(height), -normal, other_side(side), false);
        return distance;
    }
    const bool is_near = square(distance) - square(height) <= square(widest_blend * radius_);
    if (is_near && is_blended(t, nearest, is_front, center_)) keep(overlap, normal, side, true);
    if (!is_nearest(t, nearest)) return distance;
    if (distance < radius_) join_sides(t, nearest);
    // So near that rounding would say where it points.
    const bool has_direction = distance > 1e-6 * radius_;
    keep(radius_ - distance, has_direction ? Vec3((center_ - nearest.point) / distance) : normal,
         side, false);
    return distance;
}

/// Whether no way along the surface leads from a point of an edge or a corner nearer to the center.
bool BallTouches::is_nearest(std::uint32_t t, const TrianglePoint& nearest) const {
    const Vec3 from = center_ - nearest.point;
    const auto leads_nearer = [&](const Vec3& way) {
        const double along = from.dot(way);
        return along > 0.0 && along > rounding * radius_ * way.norm();
    };
    if (nearest.is_corner()) {
        const std::uint32_t vertex = mesh_.triangles[t][nearest.part];
        for (std::uint32_t k = mesh_.fan_begin[vertex]; k < mesh_.fan_begin[vertex + 1]; ++k)
            if (leads_nearer(mesh_.vertices[mesh_.fan[k]] - nearest.point)) return false;
        return true;
    }
    // The center lies across the edge from its nearest point: ways into a triangle are as good as
    // those straight away from the edge.
    const std::uint32_t half_edge = 3 * t + nearest.part - 3;
    for (std::uint32_t h = mesh_.twins[half_edge]; h != half_edge; h = mesh_.twins[h])
        if (leads_nearer(mesh_.corner(h / 3, (h + 2) % 3) - nearest.point)) return false;
    return true;
}

/// At a corner the edges of each of its triangles come in turn.
void BallTouches::join_sides(std::uint32_t t, const TrianglePoint& nearest) {
    const Vec3 from = center_ - nearest.point;
    if (nearest.is_edge()) {
        join_around(3 * t + nearest.part - 3, from);
        return;
    }
    join_around(3 * t + nearest.part, from);
    join_around(3 * t + (nearest.part + 2) % 3, from);
}

}  // namespace dem::runtime
