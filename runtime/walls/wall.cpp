// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall.hpp"

#include "common/math/elementary.hpp"
#include "common/math/rotation.hpp"

#include <cmath>

namespace dem::runtime {

WallState wall_state(const Wall& wall, double t) {
    const WallMotion& motion = wall.motion;
    WallState state{wall.position, {}};
    state.body.orientation = wall.orientation;
    if (motion.kind == WallMotion::Kind::none || t < motion.from) return state;

    const bool moving = t < motion.until;
    const double s = (moving ? t : motion.until) - motion.from;
    switch (motion.kind) {
        case WallMotion::Kind::none:
            break;
        case WallMotion::Kind::translate:
            state.position += s * motion.velocity;
            if (moving) state.body.velocity = motion.velocity;
            break;
        case WallMotion::Kind::rotate: {
            const Quat turn = rotation_about(motion.axis, motion.rate * s);
            state.position = motion.point + turn * Vec3(wall.position - motion.point);
            state.body.orientation = turn * wall.orientation;
            if (moving) {
                state.body.angular_velocity = motion.rate * motion.axis;
                state.body.velocity =
                    state.body.angular_velocity.cross(state.position - motion.point);
            }
            break;
        }
        case WallMotion::Kind::oscillate: {
            const double omega = 2.0 * pi * motion.frequency;
            const auto [sine, cosine] = math::sin_cos(omega * s);
            state.position += motion.amplitude * sine * motion.axis;
            if (moving) {
                state.body.velocity = motion.amplitude * omega * cosine * motion.axis;
            }
            break;
        }
    }
    return state;
}

}  // namespace dem::runtime
