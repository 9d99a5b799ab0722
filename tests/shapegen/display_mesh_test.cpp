// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/revolution/display_mesh.hpp"

#include "shapegen/revolution/node_rings.hpp"
#include "tests/shapegen/sample_profiles.hpp"

#include <map>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Every edge of a closed, oriented surface is run through once in each direction.
void expect_closed(std::span<const std::array<std::uint32_t, 3>> triangles,
                   const std::string& name) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& [a, b, c] : triangles) {
        ++edges[{a, b}];
        ++edges[{b, c}];
        ++edges[{c, a}];
    }
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1) << name;
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << name;
    }
}

double volume(std::span<const Vec3> points,
              std::span<const std::array<std::uint32_t, 3>> triangles) {
    double six = 0.0;
    for (const auto& [a, b, c] : triangles) six += points[a].dot(points[b].cross(points[c]));
    return six / 6.0;
}

TEST(DisplayMesh, IsClosedAndOrientedOutwards) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const double l = profile.major_axis_length();
        const DisplayMesh coarse = display_mesh(profile, 1e-2 * l);
        const DisplayMesh fine = display_mesh(profile, 1e-4 * l);
        expect_closed(coarse.triangles.span(), name);
        const double v1 = volume(coarse.vertices.span(), coarse.triangles.span());
        const double v2 = volume(fine.vertices.span(), fine.triangles.span());
        EXPECT_GT(v1, 0.0) << name;
        EXPECT_NEAR(v1 / v2, 1.0, 0.1) << name;
    }
}

TEST(DisplayMesh, VolumeConvergesToTheSphere) {
    const DisplayMesh mesh = display_mesh(test::spheroid(1.0, 1.0), 1e-4);
    EXPECT_NEAR(volume(mesh.vertices.span(), mesh.triangles.span()), 4.0 / 3.0 * pi, 1e-3);
}

TEST(DisplayMesh, LeavesTheSurfaceByNoMoreThanTheTolerance) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const double l = profile.major_axis_length();
        const DisplayMesh mesh = display_mesh(profile, 1e-3 * l);
        EXPECT_LE(mesh.max_deviation, 1.05e-3 * l) << name;
        EXPECT_GT(mesh.max_deviation, 0.0) << name;
        EXPECT_LT(mesh.triangles.size(), 12000U) << name;
        for (const Vec3& p : mesh.vertices) {
            EXPECT_NEAR(profile.signed_distance({std::hypot(p.x(), p.y()), p.z()}), 0.0, 1e-16);
        }
    }
}

TEST(RingTriangles, CloseAnyRings) {
    for (const std::uint32_t count : {100U, 333U, 2000U}) {
        for (const auto& [name, profile] : test::all_profiles()) {
            const std::vector<Ring> rings = node_rings(profile, count);
            const Triangles triangles = ring_triangles(rings);
            expect_closed(triangles, name);
            EXPECT_EQ(triangles.size(), 2 * count - 4) << name;  // Euler, genus 0
            EXPECT_GT(volume(ring_points(rings), triangles), 0.0) << name;
        }
    }
}

}  // namespace
}  // namespace dem::shapegen
