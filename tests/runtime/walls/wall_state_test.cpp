// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/pose_table.hpp"
#include "runtime/walls/wall.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using Kind = MotionPiece::Kind;

MotionPiece simple_piece(Kind kind) {
    return {.kind = kind,
            .velocity = {0.1, 0.2, -0.3},
            .axis = Vec3(1.0, -1.0, 2.0).normalized(),
            .point = {0.1, 0.1, 0.0},
            .rate = 2.5,
            .amplitude = 0.02,
            .frequency = 3.0,
            .from = 0.5,
            .until = 1.7};
}

MotionPiece ramped_piece(Kind kind, bool is_smooth) {
    MotionPiece piece = simple_piece(kind);
    piece.ramp = 0.8;
    piece.is_ramp_smooth = is_smooth;
    piece.initial_velocity = {-0.1, 0.05, 0.0};
    piece.initial_rate = -0.7;
    return piece;
}

Motion motion_of(std::vector<MotionPiece> pieces) {
    Motion motion;
    motion.pieces = std::move(pieces);
    return motion;
}

/// Turns and lifts, again and again.
Motion ratchet() {
    MotionPiece lift = simple_piece(Kind::translate);
    lift.from = 0.05;
    lift.until = 0.2;
    MotionPiece turn = simple_piece(Kind::rotate);
    turn.from = 0.2;
    turn.until = 0.25;
    Motion motion = motion_of({lift, turn});
    motion.period = 0.31;
    return motion;
}

Motion table() {
    Motion motion = motion_of({MotionPiece{.kind = Kind::table, .from = 0.0, .until = 2.0}});
    motion.pieces[0].table = std::make_shared<const PoseTable>(std::vector<PoseTable::Row>{
        {0.0, {0.0, 0.0, 0.0}, Quat::Identity()},
        {0.7, {0.1, 0.0, 0.2}, Quat(1.0, 0.3, 0.0, 0.5).normalized()},
        {1.2, {0.3, -0.1, 0.2}, Quat(0.2, 0.3, -0.4, 0.5).normalized()},
        {2.0, {0.2, 0.0, 0.0}, Quat(-0.5, 0.3, -0.4, 0.5).normalized()}});
    return motion;
}

Motion nested() {
    Motion inner = ratchet();
    auto middle = std::make_shared<Motion>(motion_of({ramped_piece(Kind::rotate, true)}));
    middle->within = std::make_shared<const Motion>(table());
    inner.within = middle;
    return inner;
}

Wall moving_wall(Motion motion) {
    Wall wall;
    wall.position = {0.3, -0.2, 0.1};
    wall.orientation = Quat(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 3.0).normalized()));
    wall.motion = std::move(motion);
    return wall;
}

TEST(MovingWall, HasAVelocityThatIsTheDerivativeOfItsPose) {
    std::vector<Motion> motions = {{}, ratchet(), table(), nested()};
    for (const Kind kind : {Kind::translate, Kind::rotate, Kind::oscillate}) {
        motions.push_back(motion_of({simple_piece(kind)}));
        motions.push_back(motion_of({ramped_piece(kind, true)}));
        motions.push_back(motion_of({ramped_piece(kind, false)}));
    }
    const double h = 1e-6;
    for (std::size_t m = 0; m < motions.size(); ++m) {
        const Wall wall = moving_wall(motions[m]);
        for (const double t : {0.1, 0.222, 0.6, 0.91, 1.1, 1.46, 1.65, 2.4}) {
            SCOPED_TRACE(testing::Message() << "motion " << m << " at " << t);
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
}

TEST(MovingWall, StandsBeforeAndStaysWhereItIsAfterwards) {
    for (const Kind kind : {Kind::translate, Kind::rotate, Kind::oscillate}) {
        const Wall wall = moving_wall(motion_of({simple_piece(kind)}));
        EXPECT_EQ(wall_state(wall, 0.4).position, wall.position);
        EXPECT_EQ(wall_state(wall, 1.7).position, wall_state(wall, 9.0).position);
        EXPECT_EQ(wall_state(wall, 9.0).body.velocity, Vec3::Zero());
        EXPECT_EQ(wall_state(wall, 9.0).body.angular_velocity, Vec3::Zero());
    }
}

TEST(MovingWall, CarriesTheVelocityOfItsSurface) {
    Wall belt = moving_wall(motion_of({simple_piece(Kind::rotate)}));
    belt.surface_velocity = {0.3, 0.1, 0.0};
    const Wall plain = moving_wall(belt.motion);
    for (const double t : {0.2, 1.0}) {
        const WallState state = wall_state(belt, t);
        const WallState other = wall_state(plain, t);
        EXPECT_EQ(state.position, other.position);
        EXPECT_EQ(state.body.angular_velocity, other.body.angular_velocity);
        EXPECT_TRUE((state.body.velocity - other.body.velocity)
                        .isApprox(state.body.orientation * belt.surface_velocity, 1e-14));
    }
}

}  // namespace
}  // namespace dem::runtime
