// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/wall/make_wall.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "formats/template_check.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/support/sample_walls.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using sample::Surface;
using sample::usual_crease;

std::string message_of_making(const TriangleSoup& soup) {
    return message_of<Error>([&] { make_wall(soup, usual_crease); });
}

double largest_bend(const WallMesh& mesh) {
    double largest = -WallMesh::sharp;
    for (const double bend : mesh.bends) largest = std::max(largest, bend);
    return largest;
}

TEST(MakeWall, InsideOfABoxHasSixPatchesAndTwelveHollowEdges) {
    const MadeWall made = make_wall(sample::box_inside({0, 0, 0}, {1, 2, 3}).soup(), usual_crease);
    EXPECT_EQ(made.mesh.blends.size(), 6U);
    EXPECT_EQ(made.report.rim_edges, 0U);
    EXPECT_EQ(made.report.concave, 12U);
    EXPECT_EQ(made.report.convex, 0U);
    EXPECT_EQ(made.report.creases, 12U);
    EXPECT_NEAR(made.report.area, 22.0, 1e-12);
    EXPECT_NEAR(largest_bend(made.mesh), 0.0, 1e-12);
}

TEST(MakeWall, TetrahedronBulgesAtItsSixEdges) {
    const MadeWall made = make_wall(sample::tetrahedron_outside(1.0).soup(), usual_crease);
    EXPECT_EQ(made.report.convex, 6U);
    EXPECT_EQ(made.report.concave, 0U);
    // Normals of a regular tetrahedron are apart by pi - acos(1/3).
    EXPECT_NEAR(largest_bend(made.mesh), pi - math::acos(1.0 / 3.0), 1e-12);
}

TEST(MakeWall, TubeIsOnePatchWhereItsFacetsBendByLessThanTheCreaseAngle) {
    const Surface tube = sample::tube(1.0, 0.0, 2.0, 512);
    const MadeWall made = make_wall(tube.soup(), usual_crease);
    EXPECT_EQ(made.mesh.blends.size(), 1U);
    EXPECT_EQ(made.report.rim_edges, 1024U);
    EXPECT_EQ(made.report.concave, 512U);
    // Half of a facet's width times the angle between neighbors.
    const double width = 2.0 * math::sin(pi / 512);
    EXPECT_NEAR(made.mesh.blends[0], 0.5 * width * 2.0 * pi / 512, 1e-9);
    EXPECT_EQ(make_wall(sample::tube(1.0, 0.0, 2.0, 12).soup(), usual_crease).mesh.blends.size(),
              12U);
}

TEST(MakeWall, TrianglesThatFaceBackAreTurnedToTheirNeighbors) {
    TriangleSoup soup = sample::tetrahedron_outside(1.0).soup();
    std::swap(soup.triangles[2][0], soup.triangles[2][1]);
    const MadeWall made = make_wall(soup, usual_crease);
    EXPECT_TRUE(made.report.turned == 1 || made.report.turned == 3);
    EXPECT_EQ(made.report.convex + made.report.concave, 6U);
    EXPECT_TRUE(made.report.convex == 0 || made.report.concave == 0);
    check_wall_mesh(made.mesh, "x");
}

TEST(MakeWall, MoebiusBandHasASeamAndIsAWallAllTheSame) {
    Surface band;
    const int parts = 40;
    const auto at = [&](int k, double side) {
        const double turn = 2.0 * pi * k / parts;
        const auto [s, c] = math::sin_cos(turn);
        const auto [hs, hc] = math::sin_cos(0.5 * turn);
        return Vec3((1.0 + side * hc) * c, (1.0 + side * hc) * s, side * hs);
    };
    for (int k = 0; k < parts; ++k) {
        const bool last = k + 1 == parts;
        band.add_quad(at(k, -0.2), at(last ? 0 : k + 1, last ? 0.2 : -0.2),
                      at(last ? 0 : k + 1, last ? -0.2 : 0.2), at(k, 0.2));
    }
    const MadeWall made = make_wall(band.soup(), usual_crease);
    EXPECT_EQ(made.report.seams, 1U);
    EXPECT_EQ(made.report.pieces, 1U);
    check_wall_mesh(made.mesh, "x");
}

TEST(MakeWall, ThreeSheetsThatMeetInAnEdgeShareItsRing) {
    Surface sheets;
    const Vec3 a(0, 0, 0);
    const Vec3 b(0, 1, 0);
    for (const Vec3& c : {Vec3(1, 0.5, 0), Vec3(-1, 0.5, 0), Vec3(0, 0.5, 1)}) sheets.add(a, b, c);
    const MadeWall made = make_wall(sheets.soup(), usual_crease);
    EXPECT_EQ(made.report.joints, 1U);
    EXPECT_EQ(made.mesh.blends.size(), 3U);
    check_wall_mesh(made.mesh, "x");
}

TEST(MakeWall, TreeFindsTheTrianglesThatALoopOverAllFinds) {
    const WallMesh mesh = sample::tube(1.0, 0.0, 2.0, 300).wall();
    Random random(7, 0);
    for (int k = 0; k < 200; ++k) {
        const Vec3 x(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                     random.uniform(-0.5, 2.5));
        double nearest = 10.0;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 q =
                nearest_on_triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), x)
                    .point;
            nearest = std::min(nearest, (x - q).norm());
        }
        EXPECT_NEAR(distance_within(mesh, x, 10.0), nearest, 1e-15);
        std::set<std::uint32_t> visited;
        visit_near_triangles(mesh, x, 0.3, [&](std::uint32_t t) { visited.insert(t); });
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 q =
                nearest_on_triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), x)
                    .point;
            if ((x - q).norm() < 0.3) {
                EXPECT_TRUE(visited.contains(t));
            }
        }
    }
}

TEST(MakeWall, SegmentsOutOfAClosedSurfaceCrossItAndThoseWithinDoNot) {
    const WallMesh mesh = sample::box_inside({-1, -1, -1}, {1, 1, 1}).wall();
    const auto none = static_cast<std::uint32_t>(mesh.triangles.size());
    Random random(3, 0);
    const auto point = [&](double reach) {
        return Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach),
                    random.uniform(-reach, reach));
    };
    for (int k = 0; k < 1000; ++k) {
        const Vec3 inside = point(0.999);
        EXPECT_EQ(first_crossed(mesh, inside, point(0.999)), none);
        EXPECT_NE(first_crossed(mesh, inside, 3.0 * point(1.0).normalized()), none);
    }
    // Through the corner, the middle of an edge, along a diagonal of a face.
    EXPECT_NE(first_crossed(mesh, {0, 0, 0}, {2, 2, 2}), none);
    EXPECT_NE(first_crossed(mesh, {0, 0, 0}, {2, 2, 0}), none);
    EXPECT_NE(first_crossed(mesh, {0, 0, 0}, {0, 0, 2}), none);
}

TEST(MakeWall, WhatIsNoSurfaceIsRefusedWithALine) {
    EXPECT_NE(message_of_making({}).find("no triangles"), std::string::npos);
    TriangleSoup soup = sample::tetrahedron_outside(1.0).soup();
    soup.points[1].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(message_of_making(soup).find("not a number"), std::string::npos);
    Surface flat;
    flat.add({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    EXPECT_NE(message_of_making(flat.soup()).find("no area"), std::string::npos);
    TriangleSoup point = sample::tetrahedron_outside(1.0).soup();
    point.triangles[3][1] = point.triangles[3][0];
    EXPECT_NE(message_of_making(point).find("no area in triangle 3"), std::string::npos);
}

}  // namespace
}  // namespace dem::shapegen
