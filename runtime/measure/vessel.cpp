// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/vessel.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

constexpr double upright = 1.0 - 1e-9;

Vec3 axis_of(const Wall& wall) {
    return wall.orientation * Vec3::UnitZ();
}

std::optional<double> floor_height(const Scene& scene, const Vec3& up) {
    double height = -infinite;
    for (const Wall& wall : scene.walls) {
        if (std::holds_alternative<PlaneWall>(wall.shape) && axis_of(wall).dot(up) > upright) {
            height = std::max(height, wall.position.dot(up));
        }
    }
    if (std::isinf(height)) return std::nullopt;
    return height;
}

std::optional<Vessel> upright_cylinder(const Scene& scene, const Vec3& up) {
    for (const Wall& wall : scene.walls) {
        const auto* cylinder = std::get_if<CylinderWall>(&wall.shape);
        if (cylinder == nullptr || !cylinder->inside) continue;
        if (std::abs(axis_of(wall).dot(up)) < upright) continue;
        Vessel vessel{Vessel::Shape::cylinder, up,
                      wall.position,           0.0,
                      cylinder->radius,        pi * square(cylinder->radius),
                      up.unitOrthogonal(),     0.0};
        const double end = wall.position.dot(up);
        const double other = end + cylinder->length * axis_of(wall).dot(up);
        vessel.floor = floor_height(scene, up).value_or(std::min(end, other));
        if (std::isinf(vessel.floor)) return std::nullopt;
        return vessel;
    }
    return std::nullopt;
}

// Two pairs of upright planes that face each other, at right angles, and a floor.
std::optional<Vessel> upright_box(const Scene& scene, const Vec3& up) {
    const auto floor = floor_height(scene, up);
    if (!floor) return std::nullopt;
    Vec3 side = Vec3::Zero();  // a horizontal normal of the box
    for (const Wall& wall : scene.walls) {
        const bool is_plane = std::holds_alternative<PlaneWall>(wall.shape);
        if (is_plane && std::abs(axis_of(wall).dot(up)) < 1e-9) side = axis_of(wall);
    }
    if (side.isZero()) return std::nullopt;
    Vec3 low = Vec3::Constant(-infinite);
    Vec3 high = Vec3::Constant(infinite);
    const Vec3 other = up.cross(side);
    for (const Wall& wall : scene.walls) {
        if (!std::holds_alternative<PlaneWall>(wall.shape)) continue;
        const Vec3 normal = axis_of(wall);
        for (const auto& [k, axis] : {std::pair{0, side}, std::pair{1, other}}) {
            const double height = wall.position.dot(axis);
            if (normal.dot(axis) > upright) low[k] = std::max(low[k], height);
            if (normal.dot(axis) < -upright) high[k] = std::min(high[k], height);
        }
    }
    const double width = high.x() - low.x();
    const double depth = high.y() - low.y();
    if (std::isinf(width) || std::isinf(depth)) return std::nullopt;
    const Vec3 center =
        0.5 * (low.x() + high.x()) * side + 0.5 * (low.y() + high.y()) * other + *floor * up;
    const double radius = 0.5 * math::hypot(width, depth);
    return Vessel{Vessel::Shape::box, up, center, *floor, radius, width * depth, side, width};
}

}  // namespace

std::optional<Vessel> find_vessel(const Scene& scene) {
    const Vec3 up = up_direction(scene);
    if (auto vessel = upright_cylinder(scene, up)) return vessel;
    return upright_box(scene, up);
}

}  // namespace dem::runtime
