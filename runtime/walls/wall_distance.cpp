// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall_distance.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

// Bodies behind a disc are let through until their centre is in front, so both of its sides count.
double distance(const PlaneWall& plane, double rho, double z) {
    if (std::isinf(plane.radius)) return z;
    return math::hypot(std::max(0.0, rho - plane.radius), z);
}

double distance(const CylinderWall& cylinder, double rho, double z) {
    const double inwards = cylinder.radius - rho;
    const double beyond =
        std::isinf(cylinder.length) ? -cylinder.length : std::max(-z, z - cylinder.length);
    if (cylinder.inside) {
        return beyond > 0.0 ? math::hypot(std::max(0.0, inwards), beyond) : inwards;
    }
    const double outside = math::hypot(std::max(0.0, -inwards), std::max(0.0, beyond));
    return outside > 0.0 ? outside : std::max(-inwards, beyond);
}

}  // namespace

double wall_distance(const WallShape& shape, const WallState& state, const Vec3& point) {
    const Vec3 x = point - state.position;
    const Vec3 axis = state.body.orientation * Vec3::UnitZ();
    const double z = x.dot(axis);
    const double rho = (x - z * axis).norm();
    return std::visit([&](const auto& wall) { return distance(wall, rho, z); }, shape);
}

}  // namespace dem
