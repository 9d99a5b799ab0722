// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/walls/wall.hpp"

namespace dem::runtime {

/// Lower bound of the distance from a point of the world to where the wall acts [m]: a body within
/// r of the point cannot touch the wall when this is more than r. Exact in front of the wall.
template <FieldWall Shape>
double wall_distance(const Shape& shape, const WallState& state, const Vec3& point) {
    return shape.with_field(state.frame(), 0.0,
                            [&](const auto& field) { return field.clearance(point); });
}
inline double wall_distance(const MeshWall& wall, const WallState& state, const Vec3& point) {
    return distance_within(*wall.mesh,
                           state.body.orientation.conjugate() * (point - state.position), infinite);
}
double wall_distance(const WallShape& shape, const WallState& state, const Vec3& point);

}  // namespace dem::runtime
