// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/thin.hpp"

#include "common/threads/thread_team.hpp"
#include "tests/shapegen/thinning/reference_thinning.hpp"
#include "tests/shapegen/thinning/sample_images.hpp"
#include "tests/shapegen/thinning/topology.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

constexpr std::array kinds{Skeleton::surface, Skeleton::curve, Skeleton::ultimate};

/// Axis of the tube along z, middle of the tube at a distance of 12 from it.
VoxelImage torus() {
    return test::image_of({35, 35, 11}, [](int i, int j, int k) {
        return std::hypot(std::hypot(i - 17.0, j - 17.0) - 12.0, k - 5.0) < 4.5;
    });
}

VoxelImage hollow_ball() {
    return test::image_of({25, 25, 25}, [](int i, int j, int k) {
        const double r = Vec3(i - 12, j - 12, k - 12).norm();
        return r > 5.3 && r < 11.7;
    });
}

std::vector<VoxelImage> random_images() {
    std::vector<VoxelImage> images;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        images.push_back(test::noise({12, 11, 10}, 0.1 * static_cast<double>(seed), seed));
        images.push_back(test::balls({30, 26, 28}, 12, seed));
    }
    images.push_back(test::balls({140, 16, 17}, 60, 20));  // rows of three words
    images.push_back(test::noise({133, 9, 8}, 0.6, 21));
    return images;
}

TEST(Thin, IsTheAlgorithmWordForWord) {
    std::vector<VoxelImage> images;
    for (const double density : {0.2, 0.4, 0.6, 0.8, 0.95})
        images.push_back(test::noise({9, 10, 11}, density, 7));
    images.push_back(test::noise({130, 5, 4}, 0.7, 8));
    images.push_back(test::balls({70, 12, 12}, 30, 9));
    images.push_back(test::balls({16, 18, 17}, 8, 10));
    for (std::size_t n = 0; n < images.size(); ++n)
        for (const Skeleton kind : kinds)
            EXPECT_EQ(thin(images[n], kind), test::reference_skeleton(images[n], kind))
                << n << " " << static_cast<int>(kind);
}

TEST(Thin, KeepsComponentsTunnelsAndCavities) {
    int tunnels = 0;
    int cavities = 0;
    for (const VoxelImage& image : random_images()) {
        const test::Topology before = test::topology(image);
        for (const Skeleton kind : kinds) EXPECT_EQ(test::topology(thin(image, kind)), before);
        tunnels += before.tunnels;
        cavities += before.cavities;
    }
    EXPECT_GT(tunnels, 100);  // otherwise nothing was tested
    EXPECT_GT(cavities, 100);
}

TEST(Thin, TakesVoxelsAwayAndAddsNone) {
    for (const VoxelImage& image : random_images()) {
        for (const Voxel& v : thin(image, Skeleton::surface).voxels())
            ASSERT_TRUE(image.contains(v));
    }
}

TEST(Thin, LeavesASkeletonAsItIs) {
    for (const VoxelImage& image : random_images()) {
        const VoxelImage skeleton = thin(image, Skeleton::ultimate);
        EXPECT_EQ(thin(skeleton, Skeleton::ultimate), skeleton);
    }
}

TEST(Thin, LeavesOneLayerOfAPlateUpToThreeThickAndTwoOfFour) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int thickness = 1; thickness <= 4; ++thickness) {
            std::array<int, 3> size{25, 25, 25};
            size[static_cast<std::size_t>(axis)] = thickness;
            const VoxelImage plate = test::image_of(size, [](int, int, int) { return true; });
            const std::vector<Voxel> left = thin(plate, Skeleton::surface).voxels();
            std::set<int> layers;
            for (const Voxel& v : left) layers.insert(v[static_cast<std::size_t>(axis)]);
            EXPECT_EQ(layers.size(), thickness < 4 ? 1U : 2U);
            EXPECT_EQ(left.size(), layers.size() * 23 * 23) << thickness << " along " << axis;
        }
    }
}

TEST(Thin, LeavesOneVoxelOfAContractibleSet) {
    const VoxelImage ball = test::image_of({21, 23, 25}, [](int i, int j, int k) {
        return Vec3(i - 10, j - 11, k - 12).norm() < 9.7;
    });
    const VoxelImage slab = test::image_of({90, 3, 12}, [](int, int, int) { return true; });
    EXPECT_EQ(thin(ball, Skeleton::ultimate).count(), 1U);
    EXPECT_EQ(thin(slab, Skeleton::ultimate).count(), 1U);
    EXPECT_EQ(thin(VoxelImage({Vec3::Zero(), 1.0, {5, 5, 5}}), Skeleton::ultimate).count(), 0U);
}

TEST(Thin, LeavesAClosedCurveOfATorus) {
    const VoxelImage curve = thin(torus(), Skeleton::ultimate);
    EXPECT_EQ(test::topology(curve), (test::Topology{1, 1, 0}));
    for (const Voxel& v : curve.voxels()) {
        int neighbors = -1;
        for (int n = 0; n < 27; ++n)
            neighbors += curve.contains({v[0] + n % 3 - 1, v[1] + n / 3 % 3 - 1, v[2] + n / 9 - 1});
        EXPECT_EQ(neighbors, 2);
    }
}

TEST(Thin, LeavesAClosedSurfaceOfAHollowBall) {
    const VoxelImage surface = thin(hollow_ball(), Skeleton::ultimate);
    EXPECT_EQ(test::topology(surface), (test::Topology{1, 0, 1}));
    // No voxel can go without opening it: it is nowhere thicker than it has to be.
    for (const Voxel& v : surface.voxels()) ASSERT_FALSE(test::is_simple(surface, v));
}

// The medial axis of a spheroid ends at the centers of curvature of its tips, 40 - 12^2 / 40 voxels
// from its middle.
TEST(Thin, LeavesTheAxisOfASpheroidAsACurve) {
    const VoxelImage spheroid = test::image_of({81, 25, 25}, [](int i, int j, int k) {
        return Vec3((i - 40.0) / 40.0, (j - 12.0) / 12.0, (k - 12.0) / 12.0).norm() <= 1.0;
    });
    const std::vector<Voxel> axis = thin(spheroid, Skeleton::curve).voxels();
    ASSERT_FALSE(axis.empty());
    int low = axis.front()[0];
    int high = low;
    for (const Voxel& v : axis) {
        low = std::min(low, v[0]);
        high = std::max(high, v[0]);
        EXPECT_LE(std::abs(v[1] - 13), 2);
        EXPECT_LE(std::abs(v[2] - 13), 2);
    }
    EXPECT_NEAR(high - low, 2.0 * (40.0 - 12.0 * 12.0 / 40.0), 6.0);
}

TEST(Thin, DoesNotDependOnTheNumberOfThreads) {
    const VoxelImage image = test::noise({131, 131, 131}, 0.25, 30);
    for (const Skeleton kind : kinds) {
        const VoxelImage alone = thin(image, kind);
        for (const int threads : {2, 3}) {
            ThreadTeam team(threads);
            const ThreadTeam::InForce together(&team);
            EXPECT_EQ(thin(image, kind), alone) << threads;
        }
    }
}

}  // namespace
}  // namespace dem::shapegen
