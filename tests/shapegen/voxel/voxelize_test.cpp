// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/voxelize.hpp"

#include "common/random.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// Voxel (i, j, k) has its center at (i - 1, j - 1, k - 1) * spacing: edges and corners of meshes
/// with integer vertices lie on scan lines and on centers all the time.
VoxelGrid lattice(int size, double spacing = 1.0) {
    return {Vec3::Constant(-spacing), spacing, {size + 3, size + 3, size + 3}};
}

template <class Belongs>
void expect_voxels(const VoxelImage& image, Belongs belongs) {
    const auto& size = image.grid().size;
    for (int k = 1; k < size[2] - 1; ++k)
        for (int j = 1; j < size[1] - 1; ++j)
            for (int i = 1; i < size[0] - 1; ++i)
                ASSERT_EQ(image.contains({i, j, k}), belongs(image.grid().center({i, j, k})))
                    << image.grid().center({i, j, k}).transpose();
}

Vec3 integer_point(Random& random, std::uint64_t size) {
    const auto draw = [&] { return static_cast<double>(random.next() % (size + 1)); };
    return {draw(), draw(), draw()};
}

/// Exact for small integers and their halves.
double volume_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

TEST(Voxelize, IsExactForTetrahedraWithCornersOnTheLattice) {
    Random random(5, 0);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 o = integer_point(random, 6);
        Vec3 a = integer_point(random, 6);
        const Vec3 b = integer_point(random, 6);
        Vec3 c = integer_point(random, 6);
        const double volume = volume_of(o, a, b, c);
        if (volume == 0.0) continue;
        if (volume < 0.0) std::swap(a, c);
        const TriangleMesh mesh =
            sample::moved(sample::tetrahedron(a - o, b - o, c - o), Mat3::Identity(), o);
        expect_voxels(voxelize(mesh, lattice(12, 0.5)), [&](const Vec3& p) {
            return volume_of(p, a, b, c) >= 0.0 && volume_of(o, p, b, c) >= 0.0 &&
                   volume_of(o, a, p, c) >= 0.0 && volume_of(o, a, b, p) >= 0.0;
        });
    }
}

TEST(Voxelize, CountsTheClosedOctahedron) {
    for (int r = 1; r <= 30; ++r) {
        const TriangleMesh mesh = sample::sphere(r, 0);
        const VoxelGrid grid{Vec3::Constant(-r - 1), 1.0, {2 * r + 3, 2 * r + 3, 2 * r + 3}};
        EXPECT_EQ(voxelize(mesh, grid).count(),
                  static_cast<std::size_t>((2 * r + 1) * (2 * r * r + 2 * r + 3) / 3));
    }
}

TEST(Voxelize, JoinsShellsThatOverlap) {
    Random random(6, 0);
    for (int n = 0; n < 100; ++n) {
        std::vector<Aabb> boxes;
        TriangleMesh mesh;
        while (boxes.size() < 6) {
            Aabb box;
            box.extend(integer_point(random, 10));
            box.extend(integer_point(random, 10));
            if ((box.lower.array() == box.upper.array()).any()) continue;
            boxes.push_back(box);
            mesh = sample::together(mesh, sample::box(box.lower, box.upper));
        }
        expect_voxels(voxelize(mesh, lattice(10)), [&](const Vec3& p) {
            return std::any_of(boxes.begin(), boxes.end(),
                               [&](const Aabb& box) { return box.contains(p); });
        });
    }
}

TEST(Voxelize, LeavesACavityButNotItsSurfaceEmpty) {
    const TriangleMesh hollow = sample::together(
        sample::box({0, 1, 0}, {9, 10, 10}), sample::inside_out(sample::box({3, 2, 4}, {6, 7, 8})));
    expect_voxels(voxelize(hollow, lattice(10)), [](const Vec3& p) {
        const bool in_cavity =
            p.x() > 3 && p.x() < 6 && p.y() > 2 && p.y() < 7 && p.z() > 4 && p.z() < 8;
        return Aabb{Vec3(0, 1, 0), Vec3(9, 10, 10)}.contains(p) && !in_cavity;
    });
}

/// How often the surface winds around a point, from the solid angles of its triangles (Van Oosterom
/// and Strackee 1983).
double winding_number(const TriangleMesh& mesh, const Vec3& p) {
    double angle = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = (mesh.vertices[i] - p).normalized();
        const Vec3 b = (mesh.vertices[j] - p).normalized();
        const Vec3 c = (mesh.vertices[k] - p).normalized();
        angle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    return angle / (4.0 * pi);
}

TEST(Voxelize, HasThePointsTheSurfaceWindsAround) {
    Random random(7, 0);
    const Mat3 turn = random.orientation().toRotationMatrix();
    const TriangleMesh ring = sample::moved(sample::torus(3.0, 1.1, 24, 12), turn, Vec3(1, 2, 3));
    const TriangleMesh shell = sample::together(
        sample::sphere(2.0, 2),
        sample::inside_out(sample::moved(sample::sphere(1.3, 2), turn, Vec3(0.1, 0.2, 0.3))));
    for (const TriangleMesh& mesh : {ring, shell}) {
        const VoxelImage image = voxelize(mesh, 0.31);
        EXPECT_GT(image.count(), 500U);
        expect_voxels(image, [&](const Vec3& p) { return winding_number(mesh, p) > 0.5; });
    }
}

TEST(Voxelize, DoesNotDependOnTheOrderOfTheTriangles) {
    TriangleMesh mesh = sample::sphere(1.0, 3);
    const VoxelImage image = voxelize(mesh, 0.125);
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    for (auto& [a, b, c] : mesh.triangles) std::tie(a, b, c) = std::make_tuple(b, c, a);
    EXPECT_EQ(voxelize(mesh, 0.125), image);
}

TEST(Voxelize, IsTheSameFromEverySide) {
    // Every coordinate a multiple of 1/8: the image of the mirrored mesh is the mirrored image.
    TriangleMesh mesh = sample::torus(3.0, 1.0, 16, 9);
    for (Vec3& p : mesh.vertices) p = (8.0 * p).array().round() / 8.0;
    const VoxelGrid grid{Vec3::Constant(-5.0), 0.25, {41, 41, 41}};
    const VoxelImage image = voxelize(mesh, grid);
    for (int axis = 0; axis < 3; ++axis) {
        Mat3 mirror = Mat3::Identity();
        mirror(axis, axis) = -1.0;
        const VoxelImage mirrored =
            voxelize(sample::inside_out(sample::moved(mesh, mirror, Vec3::Zero())), grid);
        EXPECT_EQ(mirrored.count(), image.count());
        for (Voxel v : image.voxels()) {
            v[static_cast<std::size_t>(axis)] = 40 - v[static_cast<std::size_t>(axis)];
            ASSERT_TRUE(mirrored.contains(v));
        }
    }
}

TEST(Voxelize, LeavesOutWhatLiesOutsideTheGrid) {
    const TriangleMesh mesh = sample::sphere(3.0, 2);
    const VoxelGrid large{Vec3::Constant(-4.0), 0.25, {33, 33, 33}};
    const VoxelGrid part{Vec3(-2.0, -1.0, 0.5), 0.25, {9, 12, 15}};
    const VoxelImage whole = voxelize(mesh, large);
    const VoxelImage image = voxelize(mesh, part);
    EXPECT_GT(image.count(), 0U);
    expect_voxels(image, [&](const Vec3& p) {
        const Vec3 v = (p - large.origin) / large.spacing;
        return whole.contains({static_cast<int>(std::lround(v.x())),
                               static_cast<int>(std::lround(v.y())),
                               static_cast<int>(std::lround(v.z()))});
    });
    const VoxelGrid beside{Vec3(5.0, 0.0, 0.0), 0.25, {9, 9, 9}};
    EXPECT_EQ(voxelize(mesh, beside).count(), 0U);
}

// The error of the volume of a lattice count falls faster than the spacing.
TEST(Voxelize, HasTheVolumeOfTheMesh) {
    const TriangleMesh mesh = sample::sphere(1.0, 3);
    const double volume = enclosed_volume(mesh);
    const double spacing = voxel_spacing(volume, 100);
    EXPECT_NEAR(spacing, std::cbrt(6.0 * volume / pi) / 100.0, 1e-15);
    const double count = static_cast<double>(voxelize(mesh, spacing).count());
    EXPECT_NEAR(count * cube(spacing), volume, 1e-3 * volume);
}

}  // namespace
}  // namespace dem::shapegen
