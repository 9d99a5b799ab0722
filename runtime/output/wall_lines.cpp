// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/wall_lines.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::runtime {

namespace {

/// The half-space of the points x with (x - point) . normal >= 0.
struct HalfSpace {
    Vec3 point;
    Vec3 normal;

    double height(const Vec3& x) const { return (x - point).dot(normal); }
};

using Polygon = std::vector<Vec3>;

/// A point of a wall of revolution, at an angle around its axis [rad].
Vec3 placed(const WallState& state, const Vec2& rz, double angle) {
    const auto [sine, cosine] = math::sin_cos(angle);
    return state.position + state.body.orientation * Vec3(rz.x() * cosine, rz.x() * sine, rz.y());
}

void add_outline(Segments& lines, const Wall& wall, const WallView& view) {
    const WallState state = wall_state(wall, view.time);
    const Aabb& bodies = view.bodies;
    const Vec3 axis = state.frame().axis;
    const std::pair<double, double> ends = std::minmax(
        {(bodies.lower - state.position).dot(axis), (bodies.upper - state.position).dot(axis)});
    const WallOutline outline = std::visit(
        [&](const auto& shape) { return shape.outline(ends.first, ends.second); }, wall.shape);
    constexpr int sides = 96;
    for (const Vec2& ring : outline.rings) {
        for (int k = 0; k < sides; ++k)
            lines.emplace_back(placed(state, ring, 2.0 * pi * k / sides),
                               placed(state, ring, 2.0 * pi * (k + 1) / sides));
    }
    const auto add = [&](const std::vector<std::array<Vec3, 2>>& some) {
        for (const auto& [from, to] : some)
            lines.emplace_back(state.position + state.body.orientation * from,
                               state.position + state.body.orientation * to);
    };
    add(outline.lines);
    if (const auto* mesh = std::get_if<MeshWall>(&wall.shape))
        add(mesh->silhouette(state.body.orientation.conjugate() * view.towards_viewer));
    for (int k = 0; k < 4; ++k) {
        for (const auto& [from, to] : outline.meridians)
            lines.emplace_back(placed(state, from, 0.5 * pi * k), placed(state, to, 0.5 * pi * k));
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
std::vector<HalfSpace> near_planes(std::span<const Wall> walls, const MotionTime& time,
                                   const Aabb& box, double reach) {
    std::vector<HalfSpace> planes;
    const Vec3 center = 0.5 * (box.lower + box.upper);
    for (const Wall& wall : walls) {
        const auto* plane = std::get_if<PlaneWall>(&wall.shape);
        if (plane == nullptr || plane->is_disc()) continue;
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
void add_planes(Segments& lines, std::span<const Wall> walls, const MotionTime& time,
                const Aabb& bodies) {
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

Segments wall_lines(std::span<const Wall> walls, const WallView& view) {
    Segments lines;
    for (const Wall& wall : walls) add_outline(lines, wall, view);
    add_planes(lines, walls, view.time, view.bodies);
    return lines;
}

}  // namespace dem::runtime
