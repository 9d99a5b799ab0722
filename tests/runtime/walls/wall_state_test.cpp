// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

Wall moving_wall(WallMotion::Kind kind) {
    Wall wall;
    wall.position = {0.3, -0.2, 0.1};
    wall.orientation = Quat(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 3.0).normalized()));
    wall.motion.kind = kind;
    wall.motion.velocity = {0.1, 0.2, -0.3};
    wall.motion.axis = Vec3(1.0, -1.0, 2.0).normalized();
    wall.motion.point = {0.1, 0.1, 0.0};
    wall.motion.rate = 2.5;
    wall.motion.amplitude = 0.02;
    wall.motion.frequency = 3.0;
    wall.motion.from = 0.5;
    wall.motion.until = 1.7;
    return wall;
}

class MovingWall : public testing::TestWithParam<WallMotion::Kind> {};

TEST_P(MovingWall, VelocityIsTheDerivativeOfThePose) {
    const Wall wall = moving_wall(GetParam());
    const double h = 1e-6;
    for (const double t : {0.1, 0.6, 1.1, 1.65, 2.4}) {
        const WallState before = wall_state(wall, t - h);
        const WallState now = wall_state(wall, t);
        const WallState after = wall_state(wall, t + h);
        EXPECT_NEAR(((after.position - before.position) / (2.0 * h) - now.body.velocity).norm(),
                    0.0, 1e-8);
        const Quat turn = after.body.orientation * before.body.orientation.conjugate();
        const Vec3 spin = turn.vec() * (turn.w() < 0.0 ? -2.0 : 2.0) / (2.0 * h);
        EXPECT_NEAR((spin - now.body.angular_velocity).norm(), 0.0, 1e-8);
    }
}

TEST_P(MovingWall, StandsBeforeAndStaysWhereItIsAfterwards) {
    const Wall wall = moving_wall(GetParam());
    EXPECT_EQ(wall_state(wall, 0.4).position, wall.position);
    EXPECT_EQ(wall_state(wall, 1.7).position, wall_state(wall, 9.0).position);
    EXPECT_EQ(wall_state(wall, 9.0).body.velocity, Vec3::Zero());
    EXPECT_EQ(wall_state(wall, 9.0).body.angular_velocity, Vec3::Zero());
}

INSTANTIATE_TEST_SUITE_P(Motions, MovingWall,
                         testing::Values(WallMotion::Kind::none, WallMotion::Kind::translate,
                                         WallMotion::Kind::rotate, WallMotion::Kind::oscillate));

}  // namespace
}  // namespace dem::runtime
