// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/error.hpp"
#include "shapegen/convex/convex_display.hpp"
#include "shapegen/convex/exact_hull.hpp"
#include "shapegen/convex/fewer_vertices.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace dem::test {

using namespace shapegen;

namespace {

TEST(FewerVertices, TheErrorIsTheDistanceOfTheFarthestVertexLeftOut) {
    const ConvexPolyhedron full = exact_hull(random_points(250, {1.0, 0.8, 0.5}, 3));
    double last = 1e300;
    for (const std::size_t count : {4U, 8U, 20U, 60U, 150U}) {
        const FewerVertices fewer = with_fewer_vertices(full, count);
        EXPECT_EQ(fewer.solid.vertices.size(), count);
        const ConvexShape shape = rounded_around(fewer.solid, 0.0);
        double farthest = 0.0;
        for (const Vec3& v : full.vertices)
            farthest = std::max(farthest, surface_distance(shape, v).distance);
        EXPECT_NEAR(fewer.error_max, farthest, 1e-12);
        EXPECT_LT(fewer.error_max, last);
        last = fewer.error_max;
    }
    EXPECT_LT(with_fewer_vertices(full, 150).error_max, 0.02);
}

TEST(FewerVertices, TakesTheCornersOfACubeFirst) {
    Random random(1, 1);
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) points.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    // Low tents on three faces.
    for (int k = 0; k < 60; ++k) {
        Vec3 p(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        p[k % 3] = 1.001;
        points.push_back(p);
    }
    const FewerVertices fewer = with_fewer_vertices(exact_hull(points), 8);
    for (const Vec3& v : fewer.solid.vertices)
        EXPECT_LT((v.cwiseAbs() - Vec3::Ones()).norm(), 1e-15);
    EXPECT_NEAR(fewer.error_max, 1e-3, 1e-12);
}

TEST(FewerVertices, ASolidWithNoMoreStaysAsItIs) {
    const ConvexPolyhedron cube = exact_hull(tetrahedron_corners(1.0));
    EXPECT_EQ(with_fewer_vertices(cube, 4).solid.vertices, cube.vertices);
    EXPECT_EQ(with_fewer_vertices(cube, 9).error_max, 0.0);
}

TEST(ConvexDisplay, IsAClosedHullOfPointsOnTheSurfaceWithinItsDeviation) {
    for (const auto& [name, solid] : convex_solids()) {
        for (const double tolerance : {2e-2, 2e-3}) {
            const DisplayMesh mesh = convex_display_mesh(solid.shape, tolerance);
            for (const Vec3& v : mesh.vertices)
                EXPECT_NEAR(surface_distance(solid.shape, v).distance, 0.0, 1e-9) << name;
            EXPECT_LT(mesh.max_deviation, 2.5 * tolerance) << name;
            const TriangleMesh triangles{{mesh.vertices.begin(), mesh.vertices.end()},
                                         {mesh.triangles.begin(), mesh.triangles.end()}};
            // Closed and outward: the volume is that of the body but for a shell.
            const double missing = solid.mass_properties.volume - enclosed_volume(triangles);
            EXPECT_GT(missing, -1e-9) << name;
            EXPECT_LT(missing, mesh.max_deviation * solid.surface_area + 1e-9) << name;
            // Points of the surface by rays are no farther from the mesh than it says.
            Random random(5, 1);
            for (int k = 0; k < 200; ++k) {
                const Vec3 n = random.direction();
                double reach = 0.0;
                for (const Vec3& v : mesh.vertices) reach = std::max(reach, n.dot(v));
                EXPECT_LE(extent(solid.shape, n) - reach, 1.2 * mesh.max_deviation + 1e-9) << name;
            }
        }
    }
}

TEST(ConvexDisplay, OfAPolyhedronWithManyFacesHasNoMorePointsThanItNeeds) {
    const ConvexSolid solid =
        make_convex_polyhedron(random_points(3000, {1.0, 1.2, 0.8}, 1), 0.0, exact_hull);
    const DisplayMesh mesh = convex_display_mesh(solid.shape, 2e-3);
    EXPECT_LT(mesh.vertices.size(), 2000U);
    EXPECT_LE(mesh.max_deviation, 2e-3);
}

}  // namespace
}  // namespace dem::test
