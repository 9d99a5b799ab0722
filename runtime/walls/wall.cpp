// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall.hpp"

namespace dem::runtime {

WallState wall_state(const Wall& wall, const MotionTime& time) {
    MovingPose pose{wall.position, wall.orientation};
    carry(pose, wall.motion, time);
    WallState state{pose.position, {}};
    state.body.orientation = pose.orientation;
    state.body.velocity = pose.velocity;
    state.body.angular_velocity = pose.angular_velocity;
    if (!wall.surface_velocity.isZero(0.0))
        state.body.velocity += pose.orientation * wall.surface_velocity;
    return state;
}

}  // namespace dem::runtime
