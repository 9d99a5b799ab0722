// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/motion.hpp"

#include "common/math/rotation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using Kind = MotionPiece::Kind;

const Vec3 corner(0.3, -0.2, 0.1);

Motion motion_of(std::vector<MotionPiece> pieces) {
    Motion motion;
    motion.pieces = std::move(pieces);
    return motion;
}

Vec3 moved(const Motion& motion, const MotionTime& time) {
    MovingPose pose{corner};
    carry(pose, motion, time);
    return pose.position;
}

MotionPiece turning(const Vec3& axis, const Vec3& point, double rate) {
    return {.kind = Kind::rotate, .axis = axis.normalized(), .point = point, .rate = rate};
}

TEST(Motion, RampsToItsSpeedAndGoesTheMeanOfBothSpeedsMeanwhile) {
    for (const bool is_smooth : {false, true}) {
        MotionPiece piece{.velocity = {2.0, 0.0, 0.0}, .ramp = 0.5, .is_ramp_smooth = is_smooth};
        piece.initial_velocity = {-1.0, 0.0, 0.0};
        const Motion motion = motion_of({piece});
        const auto state = [&](double t) {
            MovingPose pose;
            carry(pose, motion, t);
            return pose;
        };
        EXPECT_EQ(state(0.0).velocity.x(), -1.0);
        EXPECT_DOUBLE_EQ(state(0.25).velocity.x(), 0.5) << "half way, half of both";
        EXPECT_DOUBLE_EQ(state(0.5).position.x(), 0.25);
        EXPECT_EQ(state(0.5).velocity.x(), 2.0);
        EXPECT_DOUBLE_EQ(state(1.5).position.x(), 2.25);
        const double start = (state(1e-4).velocity.x() + 1.0) / 1e-4;
        EXPECT_NEAR(start, is_smooth ? 0.0 : 6.0, 1e-2) << "acceleration at the start";
    }
}

TEST(Motion, TurnsAboutAnAxisThatMovesAsTheClosedFormSays) {
    const Vec3 axis = Vec3(1.0, 2.0, -1.0).normalized();
    const Vec3 point(0.1, 0.0, 0.4);
    Motion inner = motion_of({turning(axis, point, 3.0)});
    inner.within =
        std::make_shared<const Motion>(motion_of({MotionPiece{.velocity = {0.2, -0.1, 0.3}}}));
    const Vec3 sun(-0.5, 0.2, 0.0);
    Motion planet = motion_of({turning(axis, point, 3.0)});
    planet.within = std::make_shared<const Motion>(motion_of({turning(Vec3::UnitZ(), sun, -0.8)}));
    for (const double t : {0.0, 0.3, 1.7, 12.0}) {
        const Vec3 turned = point + rotation_about(axis, 3.0 * t) * Vec3(corner - point);
        EXPECT_TRUE(moved(inner, t).isApprox(turned + t * Vec3(0.2, -0.1, 0.3), 1e-14));
        const Vec3 orbit = sun + rotation_about(Vec3::UnitZ(), -0.8 * t) * Vec3(turned - sun);
        EXPECT_TRUE(moved(planet, t).isApprox(orbit, 1e-14));
    }
}

TEST(Motion, MovesByAPieceWhatThoseBeforeHaveLeft) {
    MotionPiece up{.velocity = {0.0, 0.0, 1.0}, .until = 0.5};
    MotionPiece turn = turning(Vec3::UnitX(), Vec3::Zero(), 1.0);
    turn.from = 0.7;
    const Motion motion = motion_of({up, turn});
    const Vec3 lifted = corner + Vec3(0.0, 0.0, 0.5);
    EXPECT_TRUE(moved(motion, 0.6).isApprox(lifted, 1e-15));
    EXPECT_TRUE(moved(motion, 1.7).isApprox(rotation_about(Vec3::UnitX(), 1.0) * lifted, 1e-14));
}

// A ratchet that lifts and turns about an axis aslant: after n periods it is where n of them, one
// after the other, bring it, also after a hundred thousand.
TEST(Motion, RepeatsFromWhereItThenIs) {
    MotionPiece up{.velocity = {0.0, 0.02, 0.1}, .until = 0.1};
    MotionPiece turn = turning({0.3, 0.0, 1.0}, {0.1, 0.0, 0.0}, pi);
    turn.from = 0.1;
    turn.until = 0.2;
    Motion motion = motion_of({up, turn});
    motion.period = 0.25;
    Vec3 expected = corner;
    const Quat step = rotation_about(turn.axis, 0.1 * pi);
    for (int n = 1; n <= 100000; ++n) {
        expected += 0.1 * up.velocity;
        expected = turn.point + step * Vec3(expected - turn.point);
        if (n > 12 && n % 33333 != 0) continue;
        EXPECT_LT((moved(motion, 0.25 * n + 0.001) - expected - 0.001 * up.velocity).norm(),
                  1e-10 * n)
            << n;
    }
}

TEST(Motion, ThatGoesToAndFroNeverDrifts) {
    MotionPiece out{.velocity = {0.3, 0.0, 0.0}, .until = 0.1};
    MotionPiece back{.velocity = {-0.3, 0.0, 0.0}, .from = 0.1, .until = 0.2};
    Motion motion = motion_of({out, back});
    motion.period = 0.2;
    EXPECT_LT((moved(motion, 0.2 * 1e6) - corner).norm(), 1e-9);
    EXPECT_LT((moved(motion, 0.2 * 1e6 + 0.1) - corner - Vec3(0.03, 0.0, 0.0)).norm(), 1e-9);
}

TEST(Motion, ThatWaitsForTheBodiesCountsFromWhenTheyHaveSettled) {
    Motion motion = motion_of({MotionPiece{.velocity = {1.0, 0.0, 0.0}, .until = 2.0}});
    motion.from_settled = true;
    EXPECT_EQ(moved(motion, 100.0), corner) << "not yet";
    EXPECT_EQ(moved(motion, {3.0, 5.0}), corner);
    for (const double t : {5.0, 5.5, 9.0}) {
        Motion plain = motion;
        plain.from_settled = false;
        EXPECT_EQ(moved(motion, {t, 5.0}), moved(plain, t - 5.0));
    }
}

TEST(Motion, IsNeverFasterThanItsBound) {
    MotionPiece shake{.kind = Kind::oscillate, .axis = Vec3::UnitX(), .amplitude = 0.1};
    shake.frequency = 2.0;
    shake.ramp = 0.3;
    Motion inner = motion_of({shake});
    inner.within =
        std::make_shared<const Motion>(motion_of({turning(Vec3::UnitZ(), Vec3::Zero(), -3.0)}));
    const double bound = largest_speed(inner, 0.6);
    double fastest = 0.0;
    for (int k = 0; k < 2000; ++k) {
        MovingPose pose{corner};
        carry(pose, inner, 1e-3 * k);
        fastest = std::max(fastest, pose.velocity.norm());
    }
    EXPECT_LT(fastest, bound);
    EXPECT_GT(fastest, 0.5 * bound);
}

}  // namespace
}  // namespace dem::runtime
