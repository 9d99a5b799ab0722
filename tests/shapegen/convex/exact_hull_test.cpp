// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/exact_hull.hpp"

#include "common/error.hpp"
#include "common/shapes/convex_moments.hpp"
#include "shapegen/solids/hull_faces.hpp"
#include "tests/shapegen/convex/gridded_box.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace dem::test {

using namespace shapegen;

namespace {

double volume(const ConvexPolyhedron& solid) {
    return convex_moments(rounded_around(solid, 0.0)).volume;
}

TEST(ExactHull, HoldsEveryPointForManyShapesOfCloud) {
    for (const std::size_t count : {4U, 5U, 12U, 100U, 2000U}) {
        for (const Vec3& axes : {Vec3(1, 1, 1), Vec3(1000, 1, 1), Vec3(1, 1, 1e-3)}) {
            const std::vector<Vec3> points = random_points(count, axes, 7);
            const ConvexPolyhedron hull = exact_hull(points);
            EXPECT_EQ(hull.vertices.size(), count);  // all lie on an ellipsoid
            for (std::size_t f = 0; f < hull.faces.size(); ++f) {
                const Vec3 n = hull.normal(f);
                const double offset = hull.offset(f, n);
                for (const Vec3& p : points) ASSERT_LE(n.dot(p), offset + 3e-9 * axes.norm());
            }
        }
    }
}

/// How far a corner of a face lies inside of the line through its neighbors at most.
double deepest_notch(const ConvexPolyhedron& solid) {
    double deepest = 0.0;
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        const auto& face = solid.faces[f];
        const auto corner = [&](std::size_t k) { return solid.vertices[face[k % face.size()]]; };
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3 along = (corner(k + 2) - corner(k)).normalized();
            const double turn = solid.normal(f).dot((corner(k + 1) - corner(k)).cross(along));
            deepest = std::max(deepest, -turn);
        }
    }
    return deepest;
}

TEST(ExactHull, IsTheHullByForceAndErodesAsIt) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        for (const std::size_t count : {4U, 6U, 20U, 60U}) {
            const std::vector<Vec3> points = random_points(count, {1.0, 0.7, 0.5}, seed);
            const ConvexPolyhedron hull = exact_hull(points);
            const ConvexPolyhedron expected = hull_by_force(points);
            EXPECT_EQ(hull.vertices, expected.vertices);
            EXPECT_EQ(hull.faces, expected.faces);
            const ConvexPolyhedron core = eroded(hull, 0.01, exact_hull);
            const ConvexPolyhedron expected_core = eroded(expected, 0.01, hull_by_force);
            EXPECT_EQ(core.vertices, expected_core.vertices);
            EXPECT_EQ(core.faces, expected_core.faces);
        }
        // Faces of four corners.
        Random random(seed, 7);
        const Quat turn = random.orientation();
        std::vector<Vec3> corners;
        for (int k = 0; k < 8; ++k)
            corners.emplace_back(turn * Vec3(k & 1 ? 1 : -1, k & 2 ? 2 : -2, k & 4 ? 3 : -3));
        EXPECT_EQ(exact_hull(corners).faces, hull_by_force(corners).faces);
    }
}

TEST(ExactHull, OfAFineBoxInSinglePrecisionErodesAsTheBox) {
    // Some points see a face that faces inwards, or none, where heights are told by a tolerance.
    const Vec3 edges(5.672, 5.387, 0.4734);
    const double depth = 0.02;
    Random random(3, 1);
    for (int k = 0; k < 60; ++k) {
        const Quat attitude = random.orientation();
        const ConvexPolyhedron hull = exact_hull(gridded_box(edges, 6 + k % 10, attitude));
        EXPECT_NEAR(volume(hull) / edges.prod(), 1.0, 2e-6) << k;
        const ConvexPolyhedron core = eroded(hull, depth, exact_hull);
        const double expected = (edges - Vec3::Constant(2.0 * depth)).prod();
        EXPECT_NEAR(volume(core) / expected, 1.0, 2e-6) << k;
        // Some of the points lie by about what counts as flat beside a plane: which triangles join
        // must not make faces of any form. (Twice 1e-9 of the extent: thin triangles join as well.)
        EXPECT_LT(deepest_notch(hull), 2e-9 * edges.norm()) << k;
        EXPECT_LT(deepest_notch(core), 2e-9 * edges.norm()) << k;
    }
}

TEST(ExactHull, KeepsEveryPointOfASphereInSinglePrecisionFarFromTheOrigin) {
    std::vector<Vec3> points = random_points(5000, {1.0, 1.0, 1.0}, 5);
    for (Vec3& p : points) p = single_precision(p + Vec3(10.0, 20.0, 30.0));
    const ConvexPolyhedron hull = exact_hull(points);
    EXPECT_EQ(hull.vertices, points);
}

TEST(ExactHull, OfACubeWithPointsOnAndInItHasWholeFaces) {
    std::vector<Vec3> points = gridded_box(Vec3::Ones(), 4, Quat::Identity());
    points.emplace_back(0.3, 0.4, 0.5);
    const ConvexPolyhedron hull = exact_hull(points);
    EXPECT_EQ(hull.vertices.size(), 8U);
    EXPECT_EQ(hull.faces.size(), 6U);
}

TEST(ExactHull, RefusesWhatIsNoSolid) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}};
    const std::vector<Vec3> nearly{{0, 0, 0}, {1, 0, 1e-12}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}};
    const std::vector<Vec3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const std::vector<Vec3> point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const std::vector<Vec3> broken{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, nan, 1}};
    for (const auto& points : {three, flat, nearly, line, point, broken})
        EXPECT_THROW(exact_hull(points), Error);
}

}  // namespace
}  // namespace dem::test
