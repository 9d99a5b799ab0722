// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/revolution/sdf.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "common/shapes/sdf_quadtree.hpp"
#include "shapegen/certificate/sdf_error.hpp"
#include "tests/shapegen/sample_profiles.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

TEST(Sdf, IsAccurateNearTheSurface) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const double l = profile.major_axis_length();
        const SdfQuadtree sdf = signed_distance_field(profile, {});
        const SdfError error = sdf_error(profile, sdf, l / 200.0);
        EXPECT_LT(error.mean, 3e-5 * l) << name;
        EXPECT_LT(error.max, 5e-4 * l) << name;
    }
}

TEST(Sdf, IsExactAtTheGridPointsOfTheBase) {
    const Profile profile = test::tablet();
    const SdfQuadtree sdf = signed_distance_field(profile, {});
    for (std::uint32_t k = 0; k <= sdf.cells_z; ++k) {
        for (std::uint32_t i = 1; i <= sdf.cells_r; ++i) {
            const Vec2 x{sdf.origin_r + i * sdf.base_size, sdf.origin_z + k * sdf.base_size};
            EXPECT_NEAR(interpolate(sdf, x[0], x[1]).distance, profile.signed_distance(x), 1e-15);
        }
    }
}

TEST(Sdf, IsContinuousAcrossEverySeam) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const SdfQuadtree sdf = signed_distance_field(profile, {});
        const double step = 1e-9 * sdf.base_size;
        Random random(1, 2);
        for (int n = 0; n < 20000; ++n) {
            const double along = random.uniform(0.5, sdf.cells_z - 0.5);
            const auto line = static_cast<double>(1 + random.next() % (sdf.cells_r - 1));
            const double r = sdf.origin_r + sdf.base_size * line;
            const double z = sdf.origin_z + sdf.base_size * along;
            EXPECT_NEAR(interpolate(sdf, r - step, z).distance,
                        interpolate(sdf, r + step, z).distance, 4.0 * step)
                << name << " at " << r << ", " << z;
        }
    }
}

TEST(Sdf, HoldsEveryPointWithinItsMargin) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const double l = profile.major_axis_length();
        for (const double wanted : {0.0, 0.2 * l}) {
            const SdfQuadtree sdf = signed_distance_field(profile, {}, wanted);
            EXPECT_GE(sdf.margin, std::max(wanted, 0.02 * l)) << name;
            const double rounding = 1e-12 * l;
            const double above = sdf.origin_z + sdf.cells_z * sdf.base_size;
            const double right = sdf.origin_r + sdf.cells_r * sdf.base_size;
            EXPECT_LE(sdf.origin_z, profile.min_z() - sdf.margin + rounding) << name;
            EXPECT_GE(above, profile.max_z() + sdf.margin - rounding) << name;
            EXPECT_GE(right, profile.max_radius() + sdf.margin - rounding) << name;
        }
    }
}

TEST(Sdf, IsFlatAcrossTheAxis) {
    const SdfQuadtree sdf = signed_distance_field(test::candy(), {});
    EXPECT_EQ(interpolate(sdf, 0.0, 3.395e-3).d_dr, 0.0);
    EXPECT_EQ(interpolate(sdf, 0.0, -3.395e-3).d_dr, 0.0);
}

TEST(Sdf, NeverExceedsTheDistanceOutsideTheGrid) {
    const Profile profile = test::grooved();
    SdfQuadtree sdf = signed_distance_field(profile, {});
    const double slack =
        2.0 * sdf_error(profile, sdf, profile.major_axis_length() / 200).max_outside;
    Random random(3, 4);
    for (int n = 0; n < 20000; ++n) {
        const Vec2 x{random.uniform(0.0, 20e-3), random.uniform(-20e-3, 20e-3)};
        const Vec2 y{random.uniform(0.0, 20e-3), random.uniform(-20e-3, 20e-3)};
        const double at_x = interpolate(sdf, x[0], x[1]).distance;
        const double at_y = interpolate(sdf, y[0], y[1]).distance;
        if (at_x <= 0.0 || at_y <= 0.0) continue;
        EXPECT_LE(at_x, profile.signed_distance(x) + slack);
        EXPECT_LE(at_x - at_y, (x - y).norm() + 2.0 * slack);
    }
}

TEST(Sdf, GradientIsThatOfTheInterpolant) {
    const SdfQuadtree sdf = signed_distance_field(test::tablet(), {});
    const double h = 1e-10;
    Random random(5, 6);
    int compared = 0;
    for (int n = 0; n < 5000; ++n) {
        const double r = random.uniform(0.1e-3, 9e-3);
        const double z = random.uniform(-6e-3, 6e-3);
        const SdfSample s = interpolate(sdf, r, z);
        const double right = (interpolate(sdf, r + h, z).distance - s.distance) / h;
        const double left = (s.distance - interpolate(sdf, r - h, z).distance) / h;
        if (std::abs(right - left) > 1e-4) continue;  // the step crossed into another cell
        EXPECT_NEAR(s.d_dr, 0.5 * (left + right), 1e-4);
        ++compared;
    }
    EXPECT_GT(compared, 4900);
}

TEST(Sdf, ErrorFallsWithTheSquareOfTheCellSize) {
    const Profile profile = test::spheroid(2e-3, 2e-3);
    const SdfResolution coarse{50, 100, 100};
    const SdfResolution fine{50, 200, 200};
    const double h = profile.major_axis_length() / 200.0;
    const double e1 = sdf_error(profile, signed_distance_field(profile, coarse), h).mean;
    const double e2 = sdf_error(profile, signed_distance_field(profile, fine), h).mean;
    EXPECT_NEAR(e1 / e2, 4.0, 0.4);
}

TEST(Sdf, RefusesRatiosThatAreNoPowersOfTwo) {
    EXPECT_THROW(check_resolution({50, 150, 800}), UsageError);
    EXPECT_THROW(check_resolution({50, 200, 100}), UsageError);
    EXPECT_THROW(check_resolution({0, 200, 800}), UsageError);
    EXPECT_NO_THROW(check_resolution({50, 50, 50}));
}

}  // namespace
}  // namespace dem::shapegen
