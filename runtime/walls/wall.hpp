// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace dem::runtime {

/// A prescribed motion, active for from <= t < until; before it the wall stands, after it the wall
/// stays where it is. The pose is a closed form of time: no drift, nothing to store for a restart.
struct WallMotion {
    enum class Kind : std::uint8_t { none, translate, rotate, oscillate };
    Kind kind = Kind::none;
    Vec3 velocity = Vec3::Zero();  ///< translate [m/s]
    Vec3 axis = Vec3::UnitZ();     ///< rotate: unit axis; oscillate: unit direction
    Vec3 point = Vec3::Zero();     ///< rotate: a point of the axis [m]
    double rate = 0.0;             ///< rotate [rad/s]
    double amplitude = 0.0;        ///< oscillate [m]
    double frequency = 0.0;        ///< oscillate [Hz]
    double from = 0.0;             ///< [s]
    double until = std::numeric_limits<double>::infinity();  ///< [s]
};

struct Wall {
    std::string name;
    WallShape shape;               ///< in the wall's own frame (wall_shapes.hpp)
    Vec3 position = Vec3::Zero();  ///< of the wall's origin at time 0 [m]
    Quat orientation = Quat::Identity();
    WallMotion motion;
    Vec3 torque_point = Vec3::Zero();  ///< about which measures give torques, fixed in space [m]
    std::uint32_t material = 0;
};

struct WallState {
    Vec3 position;   ///< [m]
    BodyState body;  ///< orientation, velocity and angular velocity; zero inverse inertia

    WallFrame frame() const { return {position, body.orientation * Vec3::UnitZ()}; }
};

/// Where a wall is and how it moves at time t [s].
WallState wall_state(const Wall& wall, double t);

}  // namespace dem::runtime
