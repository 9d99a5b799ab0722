// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/support.hpp"

#include "common/shapes/support_map.hpp"
#include "shapegen/revolution/convexity.hpp"
#include "tests/shapegen/profile/sample_profiles.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

std::vector<std::pair<std::string, Profile>> convex_shapes() {
    auto shapes = sample::all();
    std::erase_if(shapes, [](const auto& s) { return !convexity(s.second).is_convex; });
    std::vector<Vec2> points;  // an ellipse as a table of points
    for (int i = 0; i <= 300; ++i) {
        const double s = pi * i / 300;
        points.emplace_back(i == 0 || i == 300 ? 0.0 : 2.0 * std::sin(s), -std::cos(s));
    }
    shapes.emplace_back("points", sample::polygon(points));
    // Straight sides that run smoothly into arcs of different size, and a rounded tip.
    const double angle = std::asin(0.25);
    shapes.emplace_back("drop",
                        sample::make({EllipseArc{{0, 0}, 2, 2, -0.5 * pi, angle},
                                      LineSegment{{2 * std::cos(angle), 2 * std::sin(angle)},
                                                  {std::cos(angle), 4 + std::sin(angle)}},
                                      EllipseArc{{0, 4}, 1, 1, angle, 0.5 * pi}}));
    return shapes;
}

/// Dense exact points of the profile.
std::vector<Vec2> samples_of(const Profile& profile) {
    std::vector<Vec2> points;
    for (const ProfilePiece& piece : profile.pieces())
        for (int i = 0; i <= 100; ++i)
            points.push_back(evaluate(profile.segments()[piece.segment],
                                      piece.t0 + (piece.t1 - piece.t0) * i / 100)
                                 .point);
    return points;
}

double support_value(const SupportMap& map, double angle) {
    const double n_r = std::max(std::cos(angle), 0.0);
    const SupportPoint p = support_point(map, n_r, std::sin(angle));
    return p.r * n_r + p.z * std::sin(angle);
}

TEST(SupportMap, SupportFunctionIsThatOfDenseSamples) {
    for (const auto& [name, profile] : convex_shapes()) {
        const SupportMap map = support_map(profile);
        const auto points = samples_of(profile);
        const double l = profile.major_axis_length();
        double worst = 0.0;
        for (int i = 0; i <= 2000; ++i) {
            const double angle = -0.5 * pi + pi * i / 2000;
            double brute = -1e300;
            for (const Vec2& p : points)
                brute = std::max(brute, p.x() * std::cos(angle) + p.y() * std::sin(angle));
            worst = std::max(worst, std::abs(support_value(map, angle) - brute));
        }
        EXPECT_LE(worst, 3.2e-5 * l) << name;
        EXPECT_LE(support_error(profile, map), 3.01e-5 * l) << name;
        EXPECT_GE(support_error(profile, map) + 2e-6 * l, worst) << name;
    }
}

TEST(SupportMap, ExactShapesAreExact) {
    for (const Profile& profile : {sample::sphere(2.0), sample::spheroid(6.585, 3.395)}) {
        const SupportMap map = support_map(profile);
        EXPECT_EQ(map.pieces.size(), 1U);
        EXPECT_LE(support_error(profile, map), 1e-15 * profile.major_axis_length());
    }
    // The tablet's edges and the far parts of its caps stay where they are.
    const Profile tablet = sample::tablet(5.675, 4.0, 1.23);
    const SupportMap map = support_map(tablet);
    const SupportPoint edge = support_point(map, std::sqrt(0.5), std::sqrt(0.5));
    EXPECT_EQ(edge.r, 5.675);
    EXPECT_NEAR(edge.z, 2.0, 1e-14);
    const double cap = (square(5.675) + square(1.23)) / (2.0 * 1.23);
    EXPECT_NEAR(support_value(map, 0.5 * pi - 0.1), cap + (2.0 + 1.23 - cap) * std::cos(0.1),
                1e-14);
    EXPECT_NEAR(support_point(map, 0.0, 1.0).meridional_radius, cap, 1e-13);
}

TEST(SupportMap, FreeCurvesAreCloseAndFineEnough) {
    for (const double m : {1.5, 2.5, 4.0, 8.0, 20.0}) {
        const Profile profile = sample::superquadric(1.0, 0.6, m);
        const SupportMap map = support_map(profile);
        EXPECT_LE(support_error(profile, map), 7e-6 * profile.major_axis_length()) << m;
        EXPECT_GE(map.pieces.size(), 512U) << m;
        EXPECT_LE(map.pieces.size(), 4000U) << m;
    }
}

TEST(SupportMap, PiecesJoinInPointAndNormal) {
    for (const auto& [name, profile] : convex_shapes()) {
        const SupportMap map = support_map(profile);
        const double l = profile.major_axis_length();
        for (std::size_t i = 0; i + 1 < map.pieces.size(); ++i) {
            const double q = map.piece_end[i];
            // n from q = n_z / (n_r + |n_z|): n_r : n_z = 1 - |q| : q.
            const double norm = std::hypot(1.0 - std::abs(q), q);
            const double n_r = (1.0 - std::abs(q)) / norm;
            const double n_z = q / norm;
            const auto on = [&](const SupportPiece& p) {
                const double w = p.a == p.b ? p.a : std::hypot(p.a * n_r, p.b * n_z);
                const double k = p.a == p.b ? 1.0 / (p.a > 0.0 ? p.a : 1.0) : 1.0 / w;
                return Vec2(p.center_r + p.a * p.a * k * n_r, p.center_z + p.b * p.b * k * n_z);
            };
            const double radius = std::max({map.pieces[i].a, map.pieces[i + 1].a, l});
            EXPECT_LE((on(map.pieces[i]) - on(map.pieces[i + 1])).norm(), 2e-15 * radius)
                << name << " piece " << i << " of " << map.pieces.size();
        }
        EXPECT_EQ(map.piece_end.back(), 1.0);
    }
}

TEST(SupportMap, PointIsTheGradientAndTurnsWithItsRadius) {
    for (const auto& [name, profile] : convex_shapes()) {
        const SupportMap map = support_map(profile);
        const double l = profile.major_axis_length();
        for (int i = 1; i < 400; ++i) {
            const double angle = -0.5 * pi + pi * i / 400 + 1e-3;
            const double d = 1e-5;
            const SupportPoint p = support_point(map, std::cos(angle), std::sin(angle));
            const double slope = p.z * std::cos(angle) - p.r * std::sin(angle);
            const double by_difference =
                (support_value(map, angle + d) - support_value(map, angle - d)) / (2.0 * d);
            // Across a joint the radius jumps and the difference is of first order only.
            EXPECT_NEAR(by_difference, slope, d * 2500.0 * l * 0.01) << name << " " << angle;
        }
    }
}

TEST(SupportMap, PointsMoveForwardAsTheNormalTurns) {
    // Convexity: along the tangent the points never move back.
    for (const auto& [name, profile] : convex_shapes()) {
        const SupportMap map = support_map(profile);
        const double l = profile.major_axis_length();
        SupportPoint last = support_point(map, 0.0, -1.0);
        for (int i = 1; i <= 20000; ++i) {
            const double angle = -0.5 * pi + pi * i / 20000;
            const SupportPoint p =
                support_point(map, std::max(std::cos(angle), 0.0), std::sin(angle));
            const double forward =
                (p.z - last.z) * std::cos(angle) - (p.r - last.r) * std::sin(angle);
            EXPECT_GE(forward, -2e-12 * l) << name << " at " << angle;
            EXPECT_GE(p.r, -1e-12 * l) << name;
            last = p;
        }
    }
}

TEST(SupportMap, LookUpsTakeAFewSteps) {
    for (const auto& [name, profile] : convex_shapes()) {
        const SupportMap map = support_map(profile);
        std::uint32_t longest = 0;
        for (std::size_t k = 0; k + 1 < map.first_piece.size(); ++k)
            longest = std::max(longest, map.first_piece[k + 1] - map.first_piece[k]);
        EXPECT_LE(longest, 16U) << name;
    }
}

TEST(SupportMap, ADiscStandsOnACrown) {
    // Radius 3, height 0.5: the bottom turns by 1.2e-4 l / (2 r) = 1.2e-4 to the rim and no more.
    const Profile disc = sample::cylinder(3.0, 0.5);
    const SupportMap map = support_map(disc);
    const SupportPoint bottom = support_point(map, 0.0, -1.0);
    EXPECT_EQ(bottom.r, 0.0);
    EXPECT_NEAR(bottom.z, -0.25 - 3.0 * std::tan(0.6e-4), 1e-11);
    EXPECT_NEAR(support_point(map, std::sin(1.2e-4), -std::cos(1.2e-4)).r, 3.0, 1e-9);
    EXPECT_NEAR(support_point(map, std::sin(0.6e-4), -std::cos(0.6e-4)).r, 1.5, 1e-6);
}

}  // namespace
}  // namespace dem::shapegen
