// SPDX-License-Identifier: BSD-3-Clause
#include "common/math/types.hpp"

#include "common/random.hpp"

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(OrientationTowards, TakesZThereByTheSmallestTurn) {
    Random random(1, 1);
    for (int k = 0; k < 200; ++k) {
        // A third of them next to straight down, where the formula has its pole.
        const double tilt = std::pow(10.0, random.uniform(-16.0, 0.0));
        Vec3 d = random.direction();
        if (k % 3 == 0) d = Vec3(tilt * d.x(), tilt * d.y(), -1.0).normalized();
        const Quat q = orientation_towards(3.0 * d);
        EXPECT_NEAR(q.norm(), 1.0, 1e-15);
        EXPECT_LT((body_axis(q) - d).norm(), 2e-15);
        EXPECT_EQ(q.z(), 0.0);  // no turn about the axis itself
        EXPECT_GE(q.w(), 0.0);
    }
    EXPECT_EQ(body_axis(orientation_towards(-Vec3::UnitZ())), -Vec3::UnitZ());
    EXPECT_EQ(orientation_towards(Vec3::UnitZ()).w(), 1.0);
}

}  // namespace
}  // namespace dem
