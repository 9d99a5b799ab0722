// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/ball_chain.hpp"

#include "tests/shapegen/sample_profiles.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using test::labeled;

/// Arc of a circle about a point of the axis, between two angles from the equator.
EllipseArc arc(double z, double radius, double start, double end) {
    return {Vec2(0.0, z), radius, radius, start, end};
}

TEST(BallChain, ASphereIsOneBallHoweverManyArcsItHas) {
    const BallChain one = ball_chain(test::spheroid(2e-3, 2e-3));
    ASSERT_EQ(one.balls.size(), 1U);
    EXPECT_EQ(one.balls[0].z, 0.0);
    EXPECT_EQ(one.balls[0].radius, 2e-3);
    EXPECT_LT(one.max_deviation, 1e-17);
    const Profile halves = labeled({arc(1.0, 3.0, -0.5 * pi, 0.2), arc(1.0, 3.0, 0.2, 0.5 * pi)});
    ASSERT_EQ(ball_chain(halves).balls.size(), 1U);
    EXPECT_EQ(ball_chain(halves).balls[0].z, 1.0);
}

TEST(BallChain, ADumbbellIsTwoBalls) {
    const double waist = std::asin(0.6);
    const BallChain chain =
        ball_chain(labeled({arc(-0.6, 1.0, -0.5 * pi, waist), arc(0.6, 1.0, -waist, 0.5 * pi)}));
    ASSERT_EQ(chain.balls.size(), 2U);
    EXPECT_EQ(chain.balls[0].z, -0.6);
    EXPECT_EQ(chain.balls[1].z, 0.6);
    EXPECT_LT(chain.max_deviation, 1e-15);
}

TEST(BallChain, SixDigitsAreEnough) {
    const double a = 1.0 + 5e-7;
    const BallChain chain = ball_chain(test::spheroid(1.0, a));
    ASSERT_EQ(chain.balls.size(), 1U);
    EXPECT_NEAR(chain.max_deviation, 5e-7, 1e-9);
}

TEST(BallChain, OtherBodiesHaveNone) {
    // A lens is where two balls overlap, not both of them.
    const double rim = std::acos(0.6);
    const Profile lens = labeled(
        {arc(0.6, 1.0, -0.5 * pi, -0.5 * pi + rim), arc(-0.6, 1.0, 0.5 * pi - rim, 0.5 * pi)});
    EXPECT_TRUE(ball_chain(lens).balls.empty());
    EXPECT_TRUE(ball_chain(test::spheroid(1.0, 1.0 + 3e-6)).balls.empty());
    for (const auto& [name, profile] : test::all_profiles())
        EXPECT_EQ(ball_chain(profile).balls.empty(), name != "sphere") << name;
    // A capsule takes infinitely many.
    const Profile capsule =
        labeled({arc(-1.0, 1.0, -0.5 * pi, 0.0), LineSegment{Vec2(1.0, -1.0), Vec2(1.0, 1.0)},
                 arc(1.0, 1.0, 0.0, 0.5 * pi)});
    EXPECT_TRUE(ball_chain(capsule).balls.empty());
}

}  // namespace
}  // namespace dem::shapegen
