// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/curvature.hpp"

#include "shapegen/revolution/mass_properties.hpp"
#include "tests/shapegen/profile/sample_profiles.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

double diameter(const Profile& profile) {
    return equivalent_diameter(revolution_mass(profile).mass_properties.volume);
}

TEST(Curvature, SpheresAndCylindersHaveTheirRadii) {
    const Profile sphere = sample::sphere(2.0);
    for (const double t : {0.0, 1e-12, 1e-6, 0.3, 0.5, 1.0})
        EXPECT_NEAR(mean_curvature(sphere, 0, t), 0.5, 1e-9) << t;
    const Profile cylinder = sample::cylinder(2.0, 3.0);
    EXPECT_EQ(mean_curvature(cylinder, 0, 0.5), 0.0);
    EXPECT_EQ(mean_curvature(cylinder, 1, 0.5), 0.25);
}

TEST(Curvature, SpheroidsFollowTheTextbook) {
    // H of x^2/a^2 + z^2/c^2 = 1 at the pole c/a^2, at the equator (a^2/c^2 + 1)/(2 a).
    const double a = 5.0;
    const double c = 2.0;
    const Profile spheroid = sample::spheroid(a, c);
    EXPECT_NEAR(mean_curvature(spheroid, 0, 0.0), c / (a * a), 1e-12);
    EXPECT_NEAR(mean_curvature(spheroid, 0, 0.5), (a * a / (c * c) + 1.0) / (2.0 * a), 1e-12);
}

TEST(Curvature, IsTheRateOfGrowthOfTheArea) {
    // Moving the surface out by d changes its area by 2 H d per unit area: the integral of 2 H over
    // the surface is dA/dd. For a capsule of radius R and height h: A = 4 pi R^2 + 2 pi R h.
    const double R = 1.0;
    const double h = 2.5;
    const Profile capsule = sample::spherocylinder(R, h);
    const auto table = curvature_table(capsule, diameter(capsule)).samples;
    double sum = 0.0;
    for (std::size_t i = 1; i < table.size(); ++i)
        sum +=
            2.0 * pi * (table[i].arc_length - table[i - 1].arc_length) *
            (table[i].r * table[i].mean_curvature + table[i - 1].r * table[i - 1].mean_curvature);
    EXPECT_NEAR(sum, 8.0 * pi * R + 2.0 * pi * h, 2e-3);
}

TEST(Curvature, TableIsOrderedDenseAndWithinItsError) {
    for (const auto& [name, profile] : sample::all()) {
        const double d = diameter(profile);
        const CurvatureTable table = curvature_table(profile, d);
        EXPECT_LE(table.largest_error, 2e-2) << name;
        EXPECT_NEAR(table.samples.back().arc_length, profile.length(), 1e-12 * profile.length());
        for (std::size_t i = 1; i < table.samples.size(); ++i) {
            const CurvatureSample& a = table.samples[i - 1];
            const CurvatureSample& b = table.samples[i];
            EXPECT_GE(b.arc_length, a.arc_length) << name;
            EXPECT_LE(b.arc_length - a.arc_length, profile.length() / 190.0) << name;
            EXPECT_LE(std::abs(b.mean_curvature), 100.0 / d) << name;
            EXPECT_LE(profile.nearest({b.r, b.z}).distance, 1e-13 * profile.length()) << name;
        }
        EXPECT_LE(table.samples.size(), 4000U) << name;
    }
}

TEST(Curvature, ATableOfPointsHasTheCurvatureOfItsCurve) {
    std::vector<Vec2> points;
    constexpr int count = 200;
    for (int i = 0; i <= count; ++i) {
        const double s = pi * i / count;
        points.emplace_back(i == 0 || i == count ? 0.0 : 2.0 * std::sin(s), -std::cos(s));
    }
    const Profile table = sample::polygon(points);
    const Profile spheroid = sample::spheroid(2.0, 1.0);
    for (std::size_t k = 0; k < count; ++k)
        for (const double t : {0.5, 0.9}) {
            const double exact = mean_curvature(spheroid, 0, (static_cast<double>(k) + t) / count);
            const double tolerance = k == 0 || k + 1 == count ? 0.05 : 0.02;
            EXPECT_NEAR(mean_curvature(table, k, t), exact, tolerance * exact) << k << " " << t;
        }
}

TEST(Curvature, EdgesAreClamped) {
    const Profile cylinder = sample::cylinder(1.0, 2.0);
    const double d = diameter(cylinder);
    const auto table = curvature_table(cylinder, d).samples;
    EXPECT_EQ(std::count_if(table.begin(), table.end(),
                            [d](const auto& s) { return s.mean_curvature == 100.0 / d; }),
              2);
}

}  // namespace
}  // namespace dem::shapegen
