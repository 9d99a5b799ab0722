// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_moments.hpp"
#include "tests/support/sample_convex.hpp"

#include <gtest/gtest.h>

namespace dem::test {
namespace {

TEST(ConvexShape, SurfaceIsTheGrowthOfTheVolume) {
    for (auto [name, solid] : convex_solids()) {
        ConvexShape shape = solid.shape;
        const double h = 1e-4;
        const ConvexMoments at = convex_moments(shape);
        shape.rounding += h;
        const ConvexMoments more = convex_moments(shape);
        shape.rounding -= 2.0 * h;
        if (shape.rounding < 0.0) continue;
        const ConvexMoments less = convex_moments(shape);
        EXPECT_NEAR((more.volume - less.volume) / (2.0 * h) / at.area, 1.0, 1e-6) << name;
        EXPECT_NEAR((more.second - less.second).trace() / (2.0 * h) / at.surface_second, 1.0, 1e-6)
            << name;
    }
}

TEST(ConvexShape, TheNearestSurfacePointIsOnTheSurfaceAndNoneIsNearer) {
    for (const auto& [name, solid] : convex_solids()) {
        const ConvexShape& shape = solid.shape;
        Random random(5, 1);
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 x = random.uniform(0.01, 1.6) * shape.bounding_radius * random.direction();
            const SurfaceDistance d = surface_distance(shape, x);
            ASSERT_NEAR(d.normal.norm(), 1.0, 1e-12) << name;
            const Vec3 p = x - d.distance * d.normal;
            // All of the body is on one side of the plane through the nearest point.
            ASSERT_NEAR(d.normal.dot(p), extent(shape, d.normal), 1e-10) << name;
            if (d.distance > 0.0) continue;
            for (int k = 0; k < 100; ++k) {
                const Vec3 u = random.direction();
                ASSERT_LE(u.dot(x) - d.distance, extent(shape, u) + 1e-10) << name;
            }
        }
    }
}

TEST(ConvexShape, ClimbingFindsTheFarthestVertexFromEverywhere) {
    const ConvexSolid solid = random_polyhedron(120, 2, 0.0);
    Random random(9, 9);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 u = random.direction();
        double most = -1e300;
        for (const Vec3& v : solid.shape.vertices) most = std::max(most, u.dot(v));
        const auto start = static_cast<std::uint32_t>(random.uniform() * 120.0);
        ASSERT_EQ(core_support(solid.shape, u, start).position.dot(u), most);
    }
    EXPECT_TRUE(is_closed_hull(solid.shape));
}

}  // namespace
}  // namespace dem::test
