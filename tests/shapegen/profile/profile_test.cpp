// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "tests/shapegen/profile/sample_profiles.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

std::vector<Vec2> dense_points(const Profile& profile, int per_segment) {
    std::vector<Vec2> points;
    for (const ProfileSegment& segment : profile.segments())
        for (int i = 0; i <= per_segment; ++i)
            points.push_back(evaluate(segment, static_cast<double>(i) / per_segment).point);
    return points;
}

Vec2 random_point(const Profile& profile, Random& random) {
    const double l = profile.major_axis_length();
    return {random.uniform(0.0, profile.max_radius() + 0.3 * l),
            random.uniform(profile.min_z() - 0.3 * l, profile.max_z() + 0.3 * l)};
}

/// Even-odd rule on a fine polygon: a second way to tell inside from outside.
bool polygon_contains(const std::vector<Vec2>& points, const Vec2& x) {
    bool inside = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2& a = points[i - 1];
        const Vec2& b = points[i];
        if ((a.y() > x.y()) != (b.y() > x.y()) &&
            x.x() < a.x() + (x.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y()))
            inside = !inside;
    }
    return inside;
}

std::string message_of(const std::vector<ProfileSegment>& segments) {
    try {
        sample::make(segments);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

std::vector<ProfileSegment> lines(const std::vector<Vec2>& points) {
    std::vector<ProfileSegment> segments;
    for (std::size_t i = 1; i < points.size(); ++i)
        segments.push_back(LineSegment{points[i - 1], points[i]});
    return segments;
}

TEST(Profile, NearestPointIsNeverFartherThanTheNearestOfDenseSamples) {
    Random random(1, 0);
    for (const auto& [name, profile] : sample::all()) {
        const auto samples = dense_points(profile, 2000);
        for (int i = 0; i < 300; ++i) {
            const Vec2 x = random_point(profile, random);
            double brute = 1e300;
            for (const Vec2& p : samples) brute = std::min(brute, (p - x).norm());
            const ProfilePoint found = profile.nearest(x);
            const double step = profile.length() / 500.0;
            EXPECT_LE(found.distance, brute * (1.0 + 1e-15)) << name << " at " << x.transpose();
            EXPECT_GE(found.distance, brute - step * step / std::max(brute, step)) << name;
            EXPECT_NEAR(found.distance, (found.point - x).norm(), 1e-14 * profile.length());
            const Vec2 on_curve = evaluate(profile.segments()[found.segment], found.t).point;
            EXPECT_LE((on_curve - found.point).norm(), 1e-13 * profile.length()) << name;
        }
    }
}

TEST(Profile, NearestPointIsTheFootOfTheNormal) {
    // x = p + d n has its nearest point at p as long as d is below the distance to the medial axis.
    for (const auto& [name, profile] : sample::all()) {
        for (const ProfilePiece& piece : profile.pieces()) {
            const double t = 0.5 * (piece.t0 + piece.t1);
            const Vec2 p = evaluate(profile.segments()[piece.segment], t).point;
            const Vec2 n = profile.outward_normal(piece.segment, t);
            const double curvature =
                std::max(std::abs(piece.min_curvature), std::abs(piece.max_curvature));
            const double d = std::min(1e-3 * profile.length(), 0.3 / (curvature + 1e-9));
            for (const double side : {-d, d}) {
                const Vec2 x = p + side * n;
                if (x.x() < 0.0 || std::abs(side) > 0.2 * p.x()) continue;
                const double found = profile.signed_distance(x);
                EXPECT_NEAR(found, side, 2e-14 * profile.length())
                    << name << " at " << p.transpose();
            }
        }
    }
}

TEST(Profile, SignMatchesTheEvenOddRule) {
    Random random(2, 0);
    for (const auto& [name, profile] : sample::all()) {
        const auto samples = dense_points(profile, 4000);
        for (int i = 0; i < 200; ++i) {
            const Vec2 x = random_point(profile, random);
            if (profile.nearest(x).distance < 1e-5 * profile.length()) continue;
            EXPECT_EQ(profile.contains(x), polygon_contains(samples, x))
                << name << " at " << x.transpose();
        }
    }
}

TEST(Profile, SphereDistanceIsExactWhereItsMinimumIsFlat) {
    const Profile circle = sample::sphere(2.0);
    EXPECT_NEAR(circle.signed_distance({0.0, 0.0}), -2.0, 1e-15);
    // The same sphere as an ellipse and as a free curve: every point is nearest to the center.
    const Profile ellipse = sample::make(
        {EllipseArc{Vec2::Zero(), 2.0, std::nextafter(2.0, 3.0), -0.5 * pi, 0.5 * pi}});
    const Profile free = sample::superquadric(2.0, 2.0, 2.0);
    for (const Vec2& x : {Vec2(0.0, 0.0), Vec2(1e-9, 0.0), Vec2(1e-3, -1e-3), Vec2(0.4, 1.0)}) {
        EXPECT_NEAR(ellipse.signed_distance(x), x.norm() - 2.0, 1e-14);
        EXPECT_NEAR(free.signed_distance(x), x.norm() - 2.0, 1e-14);
    }
}

TEST(Profile, MeasuresAreThoseOfClosedForms) {
    const Profile tablet = sample::tablet(5.675, 4.0, 1.23);
    const double cap = (square(5.675) + square(1.23)) / (2.0 * 1.23);
    EXPECT_NEAR(tablet.length(), 4.0 + 2.0 * cap * std::asin(5.675 / cap), 1e-13);
    EXPECT_NEAR(tablet.max_radius(), 5.675, 1e-14);
    EXPECT_NEAR(tablet.top_z(), 3.23, 1e-14);
    EXPECT_NEAR(tablet.major_axis_length(), 11.35, 1e-13);
    // Perimeter of an ellipse a = 2, b = 1: 4 a E(e^2 = 3/4), E = 1.2110560275684595.
    EXPECT_NEAR(sample::spheroid(2.0, 1.0).length(), 4.0 * 1.2110560275684595, 1e-13);
    const Profile cell = sample::red_blood_cell(7.82);
    EXPECT_NEAR(cell.top_z(), 0.405, 1e-14);
    EXPECT_GT(cell.max_z(), 1.2);  // the rim is thicker than the dimple
    EXPECT_EQ(cell.max_z(), -cell.min_z());
}

TEST(Profile, CornersAreTheEdgesAndThePointedPoles) {
    EXPECT_TRUE(sample::sphere(1.0).corners().empty());
    EXPECT_TRUE(sample::spherocylinder(1.0, 2.0).corners().empty());
    EXPECT_TRUE(sample::superquadric(1.0, 1.0, 8.0).corners().empty());
    const auto cylinder = sample::cylinder(1.0, 2.0).corners();
    ASSERT_EQ(cylinder.size(), 2U);
    EXPECT_NEAR(cylinder[0].interior_angle, 0.5 * pi, 1e-15);
    EXPECT_EQ(cylinder[0].segment, 0U);
    const auto cone = sample::polygon({{0, -1}, {1, 0}, {0, 1}}).corners();
    ASSERT_EQ(cone.size(), 3U);
    EXPECT_EQ(cone[0].segment, 2U);  // bottom pole
    for (const auto& corner : cone) EXPECT_NEAR(corner.interior_angle, 0.5 * pi, 1e-15);
    // A re-entrant angle is not a corner.
    EXPECT_EQ(sample::polygon({{0, -1}, {1, -1}, {0.5, 0}, {1, 1}, {0, 1}}).corners().size(), 2U);
}

TEST(Profile, MovesAsAWhole) {
    for (const auto& [name, profile] : sample::all()) {
        const Profile moved = profile.translated(3.5);
        EXPECT_NEAR(moved.bottom_z(), profile.bottom_z() + 3.5, 1e-14) << name;
        EXPECT_NEAR(moved.signed_distance({0.7, 3.6}), profile.signed_distance({0.7, 0.1}), 1e-14);
    }
}

TEST(Profile, RefusesPathsThatBoundNoBody) {
    EXPECT_NE(message_of(lines({{0, -1}, {1, 1}, {1, -1}, {0, 1}}))
                  .find("sample:3: the profile "
                        "crosses"),
              std::string::npos);
    EXPECT_NE(
        message_of(lines({{0, -1}, {1, 0}, {0, 0.5}, {1, 1}, {0, 2}})).find("touches the axis"),
        std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {1, 0}, {-0.1, 0.5}, {1, 1}, {0, 2}})).find("negative"),
              std::string::npos);
    EXPECT_NE(message_of(lines({{0.1, -1}, {1, 0}, {0, 2}})).find("open"), std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {1, 0}, {0.1, 2}})).find("open"), std::string::npos);
    EXPECT_NE(message_of(lines({{0, 1}, {1, 0}, {0, -1}})).find("end above"), std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {0, 1}})).find("axis"), std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {1, 0}, {0.5, -0.5}, {0, 2}})).find("folds back"),
              std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {1, std::nan("")}, {0, 1}})).find("finite"),
              std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1}, {1, 0}, {1, 0}, {0, 1}})).find("no length"),
              std::string::npos);
    EXPECT_NE(
        message_of({LineSegment{{0, -1}, {1, 0}}, LineSegment{{1, 0.1}, {0, 1}}}).find("join"),
        std::string::npos);
    EXPECT_NE(message_of({}).find("no segments"), std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1e200}, {1e200, 0}, {0, 1e200}})).find("size of"),
              std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1e-200}, {1e-200, 0}, {0, 1e-200}})).find("size of"),
              std::string::npos);
    EXPECT_NE(message_of(lines({{0, -1e-5}, {1, 0}, {0, 1e-5}})).find("ratio"), std::string::npos);
}

TEST(Profile, FindsCrossingsOfCurves) {
    // The upper arc dips through the lower one.
    const EllipseArc lower{{0, 0}, 1.0, 1.0, -0.5 * pi, 0.0};
    EXPECT_EQ(message_of({lower, LineSegment{{1, 0}, {0, 0.5}}}), "accepted");
    EXPECT_NE(message_of({lower, LineSegment{{1, 0}, {2, 0}}, LineSegment{{2, 0}, {2, -2}},
                          LineSegment{{2, -2}, {0.2, -0.5}}, LineSegment{{0.2, -0.5}, {0, 1}}})
                  .find("crosses"),
              std::string::npos);
    // A Bezier curve with a loop crosses itself within one segment.
    EXPECT_NE(message_of({cubic_bezier({Vec2(0, -1), Vec2(4, 2), Vec2(4, -2), Vec2(0, 1)})})
                  .find("crosses"),
              std::string::npos);
    // Two arcs that touch in one point, from different sides.
    EXPECT_NE(
        message_of({LineSegment{{0, -2}, {3, -2}}, EllipseArc{{3, -1}, 1, 1, -0.5 * pi, 0.5 * pi},
                    LineSegment{{3, 0}, {2, 0}}, EllipseArc{{2, -0.5}, 0.5, 0.5, 0.5 * pi, pi},
                    LineSegment{{1.5, -0.5}, {1.5, 3}}, EllipseArc{{3, 1}, 1, 1, pi, 1.5 * pi}})
            .find("sample:"),
        std::string::npos);
}

TEST(Profile, TensOfThousandsOfPointsAreNoBurden) {
    // A wavy outline: many near misses between neighbors, checked and searched through the tree.
    std::vector<Vec2> points{{0.0, -1.0}};
    constexpr int count = 20000;
    for (int i = 1; i < count; ++i) {
        const double s = pi * i / count;
        const double r = 1.0 + 0.01 * std::cos(0.25 * pi * i);
        points.emplace_back(r * std::sin(s), -r * std::cos(s));
    }
    points.emplace_back(0.0, 1.0);
    const Profile profile = sample::polygon(points);
    EXPECT_NEAR(profile.signed_distance({2.0, 0.0}), 0.99, 1e-6);
    EXPECT_NEAR(profile.signed_distance({0.0, 0.0}), -0.99, 1e-6);
    // The last line of the same path cuts through its first part.
    points.back() = {0.3, -2.0};
    points.emplace_back(0.0, 1.0);
    EXPECT_NE(message_of(lines(points)).find("crosses"), std::string::npos);
}

}  // namespace
}  // namespace dem::shapegen
