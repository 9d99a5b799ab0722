// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/wall_lines.hpp"

#include "common/math/elementary.hpp"

#include <cmath>
#include <tuple>

namespace dem {

namespace {

/// The half-space of the points x with (x - point) . normal >= 0.
struct HalfSpace {
    Vec3 point;
    Vec3 normal;

    double height(const Vec3& x) const { return (x - point).dot(normal); }
};

using Polygon = std::vector<Vec3>;

void add_circle(Segments& lines, const WallState& state, double radius, double z) {
    constexpr int sides = 96;
    const auto point = [&](int k) -> Vec3 {
        const auto [sine, cosine] = math::sin_cos(2.0 * pi * k / sides);
        return state.position + state.body.orientation * Vec3(radius * cosine, radius * sine, z);
    };
    for (int k = 0; k < sides; ++k) lines.emplace_back(point(k), point(k + 1));
}

void add_cylinder(Segments& lines, const CylinderWall& wall, const WallState& state,
                  const Aabb& box) {
    const Vec3 axis = state.body.orientation * Vec3::UnitZ();
    double from = 0.0;
    double to = wall.length;
    if (!std::isfinite(to)) {
        std::tie(from, to) = std::minmax((box.lower - state.position).dot(axis),
                                         (box.upper - state.position).dot(axis));
    }
    add_circle(lines, state, wall.radius, from);
    add_circle(lines, state, wall.radius, to);
    for (int k = 0; k < 4; ++k) {
        const double phi = 0.5 * pi * k;
        const Vec3 side(wall.radius * math::cos(phi), wall.radius * math::sin(phi), 0.0);
        lines.emplace_back(state.position + state.body.orientation * (side + from * Vec3::UnitZ()),
                           state.position + state.body.orientation * (side + to * Vec3::UnitZ()));
    }
}

/// The part of a convex polygon on one side of a plane.
Polygon clip(const Polygon& polygon, const HalfSpace& side, double tolerance) {
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3& a = polygon[k];
        const Vec3& b = polygon[(k + 1) % polygon.size()];
        const double ha = side.height(a);
        const double hb = side.height(b);
        if (ha >= -tolerance) kept.push_back(a);
        if ((ha < -tolerance) != (hb < -tolerance)) kept.push_back(a + ha / (ha - hb) * (b - a));
    }
    return kept;
}

/// The planes without end that come within `reach` of a box.
std::vector<HalfSpace> near_planes(std::span<const Wall> walls, double time, const Aabb& box,
                                   double reach) {
    std::vector<HalfSpace> planes;
    const Vec3 center = 0.5 * (box.lower + box.upper);
    for (const Wall& wall : walls) {
        const auto* plane = std::get_if<PlaneWall>(&wall.shape);
        if (plane == nullptr || std::isfinite(plane->radius)) continue;
        const WallState state = wall_state(wall, time);
        const HalfSpace side{state.position, state.body.orientation * Vec3::UnitZ()};
        if (std::abs(side.height(center)) < reach) planes.push_back(side);
    }
    return planes;
}

std::vector<HalfSpace> sides_of(const Aabb& box) {
    std::vector<HalfSpace> sides;
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
        sides.push_back({box.lower, axis});
        sides.push_back({box.upper, -axis});
    }
    return sides;
}

// The box is extended to the planes near it, so that walls which no body touches are seen, too.
void add_planes(Segments& lines, std::span<const Wall> walls, double time, const Aabb& bodies) {
    const double size = (bodies.upper - bodies.lower).norm();
    const std::vector<HalfSpace> planes = near_planes(walls, time, bodies, size);
    Aabb box = bodies;
    for (const HalfSpace& plane : planes) {
        for (const Vec3& corner : {bodies.lower, bodies.upper}) {
            box.extend(corner - plane.height(corner) * plane.normal);
        }
    }
    const double tolerance = 1e-6 * size;
    for (const HalfSpace& plane : planes) {
        const Vec3 center = 0.5 * (box.lower + box.upper);
        const Vec3 middle = center - plane.height(center) * plane.normal;
        const Vec3 u = (box.upper - box.lower).norm() * plane.normal.unitOrthogonal();
        const Vec3 v = plane.normal.cross(u);
        Polygon polygon{middle + u + v, middle - u + v, middle - u - v, middle + u - v};
        for (const HalfSpace& side : sides_of(box)) polygon = clip(polygon, side, tolerance);
        for (const HalfSpace& other : planes) {
            if (&other != &plane) polygon = clip(polygon, other, tolerance);
        }
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            lines.emplace_back(polygon[k], polygon[(k + 1) % polygon.size()]);
        }
    }
}

}  // namespace

// Discs are the ends of cylinders, whose circles show them.
Segments wall_lines(std::span<const Wall> walls, double time, const Aabb& bodies) {
    Segments lines;
    for (const Wall& wall : walls) {
        if (const auto* cylinder = std::get_if<CylinderWall>(&wall.shape)) {
            add_cylinder(lines, *cylinder, wall_state(wall, time), bodies);
        }
    }
    add_planes(lines, walls, time, bodies);
    return lines;
}

}  // namespace dem
