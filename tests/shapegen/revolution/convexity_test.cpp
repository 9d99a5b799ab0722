// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/convexity.hpp"

#include "tests/shapegen/profile/sample_profiles.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

TEST(Convexity, TellsConvexFromDimpledShapes) {
    for (const auto& [name, profile] : sample::all()) {
        const bool expected = name != "peanut" && name != "red blood cell";
        EXPECT_EQ(convexity(profile).is_convex, expected) << name;
    }
}

TEST(Convexity, IsThatOfTheBodyNotOfTheHalfProfile) {
    // The half profile is a convex polygon in the half plane, the body has a pit at its top.
    const Profile pit = sample::polygon({{0, -1}, {1, -1}, {1, 1}, {0, 0.5}});
    EXPECT_FALSE(convexity(pit).is_convex);
    EXPECT_NEAR(convexity(pit).hull_distance, 0.5, 1e-14);
}

TEST(Convexity, MeasuresTheDepthOfADent) {
    const auto dented = [](double depth) {
        return sample::polygon({{0, -1}, {1, -1}, {1 - depth, 0}, {1, 1}, {0, 1}});
    };
    EXPECT_NEAR(convexity(dented(0.25)).hull_distance, 0.25, 1e-14);
    EXPECT_TRUE(convexity(dented(1.9e-6)).is_convex);  // l = 2
    EXPECT_FALSE(convexity(dented(2.1e-6)).is_convex);
}

TEST(Convexity, ACassiniOvalIsConvexFromSqrtTwoOn) {
    EXPECT_FALSE(convexity(sample::peanut(1.0, 1.40)).is_convex);
    EXPECT_TRUE(convexity(sample::peanut(1.0, 1.42)).is_convex);
}

}  // namespace
}  // namespace dem::shapegen
