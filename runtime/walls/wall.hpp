// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"
#include "runtime/walls/motion.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace dem::runtime {

struct Wall {
    std::string name;
    WallShape shape;               ///< in the wall's own frame (wall_shapes.hpp)
    Vec3 position = Vec3::Zero();  ///< of the wall's origin at time 0 [m]
    Quat orientation = Quat::Identity();
    Motion motion;
    Vec3 torque_point = Vec3::Zero();  ///< about which measures give torques, fixed in space [m]
    std::uint32_t material = 0;
    /// Of the surface, along it, in the wall's own frame, beside what the motion does: belts [m/s].
    Vec3 surface_velocity = Vec3::Zero();
};

struct WallState {
    Vec3 position;  ///< [m]
    /// Orientation, velocity of the surface and angular velocity; zero inverse inertia.
    BodyState body;

    WallFrame frame() const { return {position, body.orientation * Vec3::UnitZ()}; }
};

/// Where a wall is and how it moves.
WallState wall_state(const Wall& wall, const MotionTime& time);

}  // namespace dem::runtime
