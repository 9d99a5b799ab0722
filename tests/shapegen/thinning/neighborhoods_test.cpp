// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/neighborhoods.hpp"

#include "tests/shapegen/thinning/sample_images.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// Sizes around multiples of 4 and 64, where bricks and words end.
std::vector<VoxelImage> images() {
    std::vector<VoxelImage> images;
    for (const int size : {1, 2, 3, 4, 5, 6, 7, 61, 62, 63, 64, 126, 127}) {
        images.push_back(test::noise({size, 5, 6}, 0.5, 1));
        images.push_back(test::noise({3, size, 2}, 0.5, 2));
        images.push_back(test::noise({4, 7, size}, 0.5, 3));
        images.push_back(test::noise({size, 9, 10}, 1.0, 4));
    }
    return images;
}

TEST(BrickImage, HasTheVoxelsOfItsVoxelImage) {
    for (const VoxelImage& image : images()) EXPECT_EQ(BrickImage(image).voxel_image(), image);
}

TEST(Neighborhoods, HoldTheVoxelsOneStepAway) {
    for (const VoxelImage& image : images()) {
        const BrickImage bricks(image);
        for (int place = 0; place < 27; ++place) {
            const Step step{place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1};
            BrickImage moved(image.grid());
            BrickImage block(image.grid());
            const bool is_in_block = step.x >= 0 && step.y >= 0 && step.z >= 0;
            for (std::ptrdiff_t i = bricks.layer_stride();
                 i < (bricks.layers() + 1) * bricks.layer_stride(); ++i) {
                // Without what would move onto the border.
                moved.bricks()[i] = neighborhoods(BrickView(bricks), i)[step] & bricks.bricks()[i];
                if (is_in_block)
                    block.bricks()[i] = blocks(BrickView(bricks), i)[step] & bricks.bricks()[i];
            }
            VoxelImage expected(image.grid());
            for (const Voxel& v : image.voxels())
                if (image.contains({v[0] + step.x, v[1] + step.y, v[2] + step.z}))
                    expected.insert(v);
            ASSERT_EQ(moved.voxel_image(), expected);
            if (is_in_block) {
                ASSERT_EQ(block.voxel_image(), expected);
            }
        }
    }
}

}  // namespace
}  // namespace dem::shapegen
