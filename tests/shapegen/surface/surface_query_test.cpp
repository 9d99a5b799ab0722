// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/surface/surface_query.hpp"

#include "common/random.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// The solid angle of the surface seen from p over 4 pi: 1 inside, 0 outside (van Oosterom and
/// Strackee 1983).
double winding_number(const TriangleMesh& mesh, const Vec3& p) {
    double sum = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = mesh.vertices[i] - p;
        const Vec3 b = mesh.vertices[j] - p;
        const Vec3 c = mesh.vertices[k] - p;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        sum += 2.0 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4.0 * pi);
}

TEST(SurfaceQuery, InsideAgreesWithTheSolidAngle) {
    Random random(13, 0);
    const TriangleMesh hollow = sample::together(
        sample::torus(3.0, 1.0, 24, 12), sample::inside_out(sample::torus(3.0, 0.5, 20, 8)));
    const SurfaceQuery surface(hollow);
    int inside = 0;
    for (int n = 0; n < 3000; ++n) {
        const Vec3 p = random.uniform(0.0, 4.5) * random.direction();
        const bool expected = winding_number(hollow, p) > 0.5;
        EXPECT_EQ(surface.is_inside(p), expected);
        EXPECT_EQ(surface.signed_distance(p) < 0.0, expected);
        EXPECT_EQ(std::abs(surface.signed_distance(p)), surface.distance(p));
        inside += expected ? 1 : 0;
    }
    EXPECT_GT(inside, 200);
}

TEST(SurfaceQuery, RaysThroughCornersAndEdgesAreCountedRight) {
    // An octahedron and its points at multiples of an eighth: all its corners, edges and faces are
    // hit exactly, from above, from below and sideways.
    const SurfaceQuery surface(sample::sphere(1.0, 0));
    for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j)
            for (int k = -12; k <= 12; ++k) {
                const Vec3 p = Vec3(i, j, k) / 8.0;
                EXPECT_EQ(surface.is_inside(p), std::abs(i) + std::abs(j) + std::abs(k) <= 8) << p;
            }
}

TEST(SurfaceQuery, BoxHoldsItsSurfaceAndNothingBeyond) {
    const SurfaceQuery surface(sample::box({-1, -1, -1}, {1, 1, 1}));
    const double above_one = std::nextafter(1.0, 2.0);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            for (const double u : {-1.0, -0.5, 0.0, 0.3, 1.0}) {
                Vec3 p = Vec3::Constant(u);
                p[axis] = sign;
                EXPECT_TRUE(surface.is_inside(p)) << p;
                p[axis] = sign * above_one;
                EXPECT_FALSE(surface.is_inside(p)) << p;
            }
    EXPECT_EQ(surface.signed_distance({0.0, 0.0, 0.0}), -1.0);
    EXPECT_EQ(surface.signed_distance({4.0, 5.0, 1.0}), 5.0);
}

TEST(SurfaceQuery, PointsAHairFromASlantedFaceAreOnTheRightSide) {
    // One ulp is far below what a ray computed in floating point could tell.
    const TriangleMesh mesh =
        sample::moved(sample::sphere(1.0, 3), Mat3::Identity(), Vec3(0.1, 0.2, 0.3));
    const SurfaceQuery surface(mesh);
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3& top = mesh.vertices[i];
        if (top.z() <= 0.3) continue;
        Vec3 p = top;
        p.z() = std::nextafter(top.z(), 10.0);
        EXPECT_FALSE(surface.is_inside(p));
        p.z() = std::nextafter(top.z(), -10.0);
        EXPECT_TRUE(surface.is_inside(p));
        EXPECT_TRUE(surface.is_inside(top));
    }
}

TEST(SurfaceQuery, OverlappingShellsAreAUnion) {
    const SurfaceQuery surface(sample::together(sample::box({-2, -1, -1}, {0.5, 1, 1}),
                                                sample::box({-0.5, -1.5, -0.5}, {2, 1.5, 0.5})));
    EXPECT_TRUE(surface.is_inside({0.0, 0.0, 0.0}));
    EXPECT_TRUE(surface.is_inside({-1.5, 0.0, 0.9}));
    EXPECT_TRUE(surface.is_inside({1.5, 1.4, 0.0}));
    EXPECT_FALSE(surface.is_inside({1.5, 0.0, 0.9}));
}

}  // namespace
}  // namespace dem::shapegen
