// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/touch.hpp"

#include "common/random.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

ParticleTemplate with_shape(decltype(ParticleTemplate::shape) shape) {
    ParticleTemplate t;
    t.is_convex = true;
    t.shape = std::move(shape);
    return t;
}

PairState at(const Vec3& displacement, const Quat& i = Quat::Identity(),
             const Quat& j = Quat::Identity()) {
    PairState pair;
    pair.displacement = displacement;
    pair.i.orientation = i;
    pair.j.orientation = j;
    return pair;
}

TEST(Touches, TurnsAtTheSumOfTheRadiiForSpheresHoweverTheyAreRepresented) {
    const std::vector<ParticleTemplate> balls{with_shape(Sphere{3e-3}),
                                              with_shape(round_body(3e-3).shape)};
    Random random(81, 1);
    for (const ParticleTemplate& a : balls) {
        for (const ParticleTemplate& b : balls) {
            const Vec3 n = random.direction();
            const Quat q = random.orientation();
            EXPECT_TRUE(touches(a, b, at(6e-3 * (1.0 - 1e-9) * n, q, q)));
            EXPECT_FALSE(touches(a, b, at(6e-3 * (1.0 + 1e-9) * n, q, q)));
            EXPECT_TRUE(touches(a, b, at(1e-4 * n, q, q)));
            EXPECT_TRUE(touches(a, b, at(Vec3::Zero(), q, q)));
        }
    }
}

TEST(Touches, ExtentAlongANormalIsWhereAPlaneStartsToTouch) {
    Random random(82, 1);
    for (const ParticleTemplate& body :
         {with_shape(tablet().shape), with_shape(candy().shape), with_shape(Sphere{2e-3})}) {
        for (int k = 0; k < 100; ++k) {
            const Quat q = random.orientation();
            const Quat wall = random.orientation();
            const Vec3 n = wall * Vec3::UnitZ();
            const double reach = extent(body, q, -n);
            EXPECT_TRUE(touches(body, WallShape(PlaneWall{}), at(-(reach - 1e-9) * n, q, wall)));
            EXPECT_FALSE(touches(body, WallShape(PlaneWall{}), at(-(reach + 1e-9) * n, q, wall)));
        }
    }
}

TEST(Touches, ABodyDeepInsideAnotherOrBeyondAWallTouches) {
    const ParticleTemplate small = with_shape(spheroid(1e-3, 0.5e-3).shape);
    const ParticleTemplate large = with_shape(cylinder(6e-3, 6e-3).shape);
    Random random(83, 1);
    for (int k = 0; k < 100; ++k) {
        const Quat q = random.orientation();
        EXPECT_TRUE(touches(small, large, at(1.5e-3 * random.direction(), q)));
        const Vec3 outside =
            random.uniform(20e-3, 40e-3) * random.direction().cross(Vec3::UnitZ()).normalized();
        EXPECT_TRUE(touches(small, WallShape(CylinderWall{20e-3}), at(-outside, q)));
    }
}

}  // namespace
}  // namespace dem::test
