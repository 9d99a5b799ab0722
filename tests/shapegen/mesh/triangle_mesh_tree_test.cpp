// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/mesh/triangle_mesh_tree.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <set>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// Distance to a triangle by projection onto its plane in a local frame and onto its edges, with
/// none of the tree's formulas.
double distance_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const auto to_segment = [&p](const Vec3& s, const Vec3& e) {
        const double t = std::clamp((p - s).dot(e - s) / (e - s).squaredNorm(), 0.0, 1.0);
        return (s + t * (e - s) - p).norm();
    };
    const double edges = std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
    const Vec3 n = (b - a).cross(c - a).normalized();
    const auto is_left = [&](const Vec3& s, const Vec3& e) {
        return n.dot((e - s).cross(p - s)) >= 0.0;
    };
    if (is_left(a, b) && is_left(b, c) && is_left(c, a)) return std::abs(n.dot(p - a));
    return edges;
}

double brute_force_distance(const TriangleMesh& mesh, const Vec3& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [i, j, k] : mesh.triangles)
        nearest = std::min(
            nearest, distance_to_triangle(mesh.vertices[i], mesh.vertices[j], mesh.vertices[k], p));
    return nearest;
}

TEST(TriangleMeshTree, NearestPointIsThatOfAllTriangles) {
    Random random(11, 0);
    const TriangleMesh mesh = sample::together(
        sample::torus(3.0, 1.0, 24, 12),
        sample::moved(sample::sphere(1.0, 2), Mat3::Identity(), Vec3(0.0, 0.0, 2.5)));
    const TriangleMeshTree tree(mesh);
    for (int n = 0; n < 2000; ++n) {
        const Vec3 p = random.uniform(0.0, 6.0) * random.direction();
        const SurfacePoint nearest = tree.nearest(p);
        EXPECT_NEAR(nearest.distance, brute_force_distance(mesh, p), 1e-14);
        EXPECT_NEAR((nearest.point - p).norm(), nearest.distance, 1e-14);
        EXPECT_EQ(tree.nearest(p, nearest.distance).point, nearest.point);
        EXPECT_EQ(tree.nearest(p, 1.1 * nearest.distance + 0.01).triangle, nearest.triangle);
        EXPECT_GT(tree.nearest(p, 0.9 * nearest.distance - 1e-12).distance,
                  0.9 * nearest.distance - 1e-12);
        const auto& [i, j, k] = mesh.triangles[nearest.triangle];
        EXPECT_LT(distance_to_triangle(mesh.vertices[i], mesh.vertices[j], mesh.vertices[k],
                                       nearest.point),
                  1e-14);
    }
}

TEST(TriangleMeshTree, TangentBallIsTheLargestThatHoldsNothing) {
    constexpr double touching = 1e-6;
    Random random(12, 0);
    const TriangleMesh mesh = sample::torus(3.0, 1.0, 24, 12);
    const TriangleMeshTree tree(mesh);
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3& a = mesh.vertices[i];
        const Vec3 ab = mesh.vertices[j] - a;
        const Vec3 ac = mesh.vertices[k] - a;
        const Vec3 q = a + random.uniform(0.1, 0.4) * ab + random.uniform(0.1, 0.4) * ac;
        const Vec3 inward = -ab.cross(ac).normalized();
        const double radius = tree.tangent_radius(q, inward, 2.0, touching);
        EXPECT_GT(radius, 0.0);
        EXPECT_LT(radius, 1.0);
        EXPECT_GE(tree.nearest(q + radius * inward).distance, radius * (1.0 - 1.01 * touching));
        const double larger = 1.001 * radius;
        EXPECT_LT(tree.nearest(q + larger * inward).distance, larger * (1.0 - touching));
        EXPECT_EQ(tree.tangent_radius(q, inward, 0.5 * radius, touching), 0.5 * radius);
    }
}

TEST(TriangleMeshTree, AmongEquallyNearTrianglesTheFirstIsNamed) {
    // Every corner belongs to several triangles; the order of the tree must not choose.
    const TriangleMesh mesh = sample::sphere(1.0, 4);
    const TriangleMeshTree tree(mesh);
    std::vector<std::uint32_t> first(mesh.vertices.size(), 0xffffffff);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t]) first[v] = std::min(first[v], t);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const SurfacePoint nearest = tree.nearest(mesh.vertices[v]);
        EXPECT_EQ(nearest.distance, 0.0);
        EXPECT_EQ(nearest.triangle, first[v]);
    }
}

TEST(TriangleMeshTree, ThinTrianglesAreAsExactAsOthers) {
    // A needle a millionth of a millionth as high as long, and one with no height at all.
    for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
        const TriangleMesh needle{
            {Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.3, 0.2), Vec3(0.5, 0.15 + height, 0.1)}, {{0, 1, 2}}};
        const TriangleMeshTree tree(needle);
        Random random(3, 0);
        for (int n = 0; n < 200; ++n) {
            const Vec3 p = 2.0 * random.direction();
            const Vec3 axis = needle.vertices[1];
            const double t = std::clamp(p.dot(axis) / axis.squaredNorm(), 0.0, 1.0);
            const double expected =
                height > 1e-7 ? brute_force_distance(needle, p) : (p - t * axis).norm();
            EXPECT_NEAR(tree.nearest(p).distance, expected, 2e-9);
            if (height == 0.0) {
                EXPECT_NEAR(tree.nearest(p).distance, expected, 1e-15);
            }
        }
    }
}

TEST(TriangleMeshTree, RayMeetsEveryTriangleAboveIt) {
    Random random(5, 0);
    const TriangleMesh mesh = sample::torus(3.0, 1.0, 24, 12);
    const TriangleMeshTree tree(mesh);
    for (int n = 0; n < 500; ++n) {
        const Vec3 p = random.uniform(0.0, 4.0) * random.direction();
        std::set<std::uint32_t> expected;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            Aabb box;
            for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.vertices[v]);
            const Vec3 up(p.x(), p.y(), std::max(p.z(), box.lower.z()));
            if (box.contains(up)) expected.insert(t);
        }
        std::set<std::uint32_t> visited;
        tree.visit_above(p, [&](std::uint32_t t) {
            // A leaf is visited whole.
            if (expected.contains(t)) {
                EXPECT_TRUE(visited.insert(t).second);
            }
        });
        EXPECT_EQ(visited, expected);
    }
}

TEST(TriangleMeshTree, MeshWithoutTrianglesIsRefused) {
    EXPECT_THROW(TriangleMeshTree{TriangleMesh{}}, Error);
}

}  // namespace
}  // namespace dem::shapegen
