// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/farthest_of_ellipse.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// Where an ellipse is farthest from a point, against a scan of its circumference.

namespace dem::runtime {
namespace {

Vec2 point_of(const Ellipse& ellipse, double angle) {
    const Vec2 minor(-ellipse.major.y(), ellipse.major.x());
    return ellipse.center + ellipse.a * std::cos(angle) * ellipse.major +
           ellipse.b * std::sin(angle) * minor;
}

/// The point with an outward normal.
Vec2 support_of(const Ellipse& ellipse, const Vec2& e) {
    const Vec2 minor(-ellipse.major.y(), ellipse.major.x());
    return point_of(ellipse,
                    std::atan2(ellipse.b * e.dot(minor), ellipse.a * e.dot(ellipse.major)));
}

/// Local maxima of the distance on a fine division of the circumference, the farthest first.
std::vector<double> scanned_maxima(const Ellipse& ellipse) {
    constexpr int division = 20000;
    std::vector<double> distance;
    for (int k = 0; k < division; ++k)
        distance.push_back(point_of(ellipse, 2.0 * pi * k / division).norm());
    std::vector<double> maxima;
    for (std::size_t k = 0; k < division; ++k) {
        const double before = distance[(k + division - 1) % division];
        if (distance[k] > before && distance[k] >= distance[(k + 1) % division])
            maxima.push_back(distance[k]);
    }
    std::sort(maxima.rbegin(), maxima.rend());
    return maxima;
}

TEST(FarthestOfEllipse, FindsEveryPlaceThatAScanFinds) {
    Random random(3, 0);
    int two = 0;
    for (int k = 0; k < 1000; ++k) {
        const double turn = random.uniform(0.0, 2.0 * pi);
        const double far = std::pow(10.0, random.uniform(-1.0, 1.5));
        const double flat = k % 3 == 0 ? 0.0 : std::pow(10.0, random.uniform(-3.0, 0.0));
        const double azimuth = random.uniform(0.0, 2.0 * pi);
        const Ellipse ellipse{far * Vec2(std::cos(azimuth), std::sin(azimuth)),
                              {std::cos(turn), std::sin(turn)},
                              1.0,
                              flat};
        const std::vector<double> expected = scanned_maxima(ellipse);
        const FarthestPlaces found = farthest_places(ellipse);
        ASSERT_EQ(found.count, expected.size()) << k;
        two += found.count == 2 ? 1 : 0;
        for (std::size_t n = 0; n < found.count; ++n) {
            const Vec2& e = found.direction[n];
            const Vec2 x = support_of(ellipse, e);
            EXPECT_NEAR(x.norm(), expected[n], 1e-7 * far + 1e-7) << k;
            EXPECT_NEAR(x.dot(e), x.norm(), 1e-12 * (1.0 + far)) << k;
        }
    }
    EXPECT_GT(two, 100);
    EXPECT_LT(two, 900);
}

TEST(FarthestOfEllipse, SeesBothCornersOfASegmentInAnyDirection) {
    for (const double tilt : {0.0, 1e-16, 1e-9, 1e-3}) {
        for (int k = 0; k < 64; ++k) {
            const double azimuth = 2.0 * pi * k / 64;
            const Vec2 outward(std::cos(azimuth), std::sin(azimuth));
            const Vec2 along(-std::sin(azimuth + tilt), std::cos(azimuth + tilt));
            const FarthestPlaces found = farthest_places({20.0 * outward, along, 1.5, 0.0});
            ASSERT_EQ(found.count, 2U) << k;
            EXPECT_NEAR(found.direction[0].dot(along) * found.direction[1].dot(along),
                        -square(1.5) / (square(20.0) + square(1.5)), 0.1 * tilt + 1e-9);
        }
    }
}

TEST(FarthestOfEllipse, ACircleHasOne) {
    const FarthestPlaces found = farthest_places(ellipse_of({3.0, 4.0}, 4.0, 0.0, 4.0));
    ASSERT_EQ(found.count, 1U);
    EXPECT_NEAR((found.direction[0] - Vec2(0.6, 0.8)).norm(), 0.0, 1e-12);
    EXPECT_EQ(farthest_places(ellipse_of({0.0, 0.0}, 4.0, 0.0, 4.0)).count, 1U);
}

TEST(FarthestOfEllipse, TheFormGivesTheAxes) {
    Random random(5, 0);
    for (int k = 0; k < 100; ++k) {
        const double turn = random.uniform(0.0, 2.0 * pi);
        const double c = std::cos(turn);
        const double s = std::sin(turn);
        const double b = random.uniform(0.1, 1.9);
        const double xx = 4.0 * c * c + b * b * s * s;
        const double xy = (4.0 - b * b) * c * s;
        const double yy = 4.0 * s * s + b * b * c * c;
        const Ellipse ellipse = ellipse_of(Vec2::Zero(), xx, xy, yy);
        EXPECT_NEAR(ellipse.a, 2.0, 1e-14);
        EXPECT_NEAR(ellipse.b, b, 1e-13);
        EXPECT_NEAR(std::abs(ellipse.major.dot(Vec2(c, s))), 1.0, 1e-14);
    }
}

}  // namespace
}  // namespace dem::runtime
