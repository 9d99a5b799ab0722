// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/voxel_image.hpp"

#include "common/error.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

TEST(VoxelImage, InsertsARunAsItsVoxels) {
    Random random(1, 0);
    for (int n = 0; n < 500; ++n) {
        const int first = 1 + static_cast<int>(random.next() % 200);
        const int last = 1 + static_cast<int>(random.next() % 200);
        VoxelImage by_run({Vec3::Zero(), 1.0, {202, 4, 5}});
        VoxelImage one_by_one(by_run.grid());
        by_run.insert_run(first, last, 2, 3);
        for (int i = first; i < last; ++i) one_by_one.insert({i, 2, 3});
        ASSERT_EQ(by_run, one_by_one) << first << " " << last;
        ASSERT_EQ(by_run.count(), static_cast<std::size_t>(std::max(last - first, 0)));
    }
}

TEST(VoxelImage, ListsItsVoxelsInTheOrderOfTheGrid) {
    Random random(2, 0);
    VoxelImage image({Vec3::Zero(), 1.0, {131, 7, 6}});
    std::vector<Voxel> expected;
    for (int k = 1; k < 5; ++k) {
        for (int j = 1; j < 6; ++j) {
            for (int i = 1; i < 130; ++i) {
                if (random.next() % 3 != 0) continue;
                image.insert({i, j, k});
                if (random.next() % 3 == 0)
                    image.erase({i, j, k});
                else
                    expected.push_back({i, j, k});
            }
        }
    }
    EXPECT_EQ(image.voxels(), expected);
    EXPECT_EQ(image.count(), expected.size());
    for (const Voxel& v : expected) EXPECT_TRUE(image.contains(v));
}

TEST(VoxelGrid, HasEveryLatticePointOfTheBoxInsideItsBorder) {
    Random random(3, 0);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 lower(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const Vec3 extent(random.uniform(), random.uniform(), n % 4 == 0 ? 0.0 : random.uniform());
        const double spacing = random.uniform(0.01, 0.6);
        const VoxelGrid grid = enclosing_grid({lower, lower + extent}, spacing);
        const Vec3 last = grid.center({grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1});
        EXPECT_LT((grid.origin + last - 2 * lower - extent).norm(), 1e-14);
        EXPECT_TRUE((grid.origin.array() < lower.array()).all());
        EXPECT_TRUE((last.array() > (lower + extent).array()).all());
    }
}

TEST(VoxelGrid, RefusesASpacingThatNeedsTooManyVoxels) {
    const Aabb box{Vec3::Zero(), Vec3(1, 2, 3)};
    for (const double spacing :
         {0.0, -1.0, 1e-5, 1e-300, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(enclosing_grid(box, spacing), Error) << spacing;
    EXPECT_THROW(enclosing_grid({Vec3::Zero(), Vec3(1e300, 0, 0)}, 1.0), Error);
    EXPECT_THROW(enclosing_grid(Aabb{}, 1.0), Error);
}

}  // namespace
}  // namespace dem::shapegen
