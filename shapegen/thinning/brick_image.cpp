// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/brick_image.hpp"

namespace dem::shapegen {

namespace {

std::ptrdiff_t bricks_along(int voxels) {
    return (voxels + 3) / 4;
}

/// Calls visit(word, brick, shift) for every row of a word: bits `shift` to shift + 3 of the brick
/// and those after it, up to 16 of them, hold its voxels, four each.
template <class Visit>
void for_each_word(const VoxelGrid& grid, const BrickImage& image, Visit visit) {
    std::ptrdiff_t word = 0;
    for (int k = 0; k < grid.size[2]; ++k) {
        for (int j = 0; j < grid.size[1]; ++j) {
            const std::ptrdiff_t row =
                (k / 4 + 1) * image.layer_stride() + j / 4 * image.row_stride();
            for (int i = 0; i < grid.size[0]; i += 64, ++word)
                visit(word, row + i / 4, 4 * (j % 4) + 16 * (k % 4));
        }
    }
}

}  // namespace

BrickImage::BrickImage(const VoxelGrid& grid)
    : grid_(grid),
      layers_(static_cast<int>(bricks_along(grid.size[2]))),
      row_stride_(bricks_along(grid.size[0])),
      layer_stride_(row_stride_ * bricks_along(grid.size[1])),
      bricks_(static_cast<std::size_t>(layer_stride_ * (layers_ + 2) + 2 * margin()), 0) {}

BrickImage::BrickImage(const VoxelImage& image) : BrickImage(image.grid()) {
    for_each_word(grid_, *this, [&](std::ptrdiff_t word, std::ptrdiff_t brick, int shift) {
        for (VoxelWord left = image.words()[word]; left != 0; left >>= 4)
            bricks()[brick++] |= (left & 0xfU) << shift;
    });
}

VoxelImage BrickImage::voxel_image() const {
    VoxelImage image(grid_);
    for_each_word(grid_, *this, [&](std::ptrdiff_t word, std::ptrdiff_t brick, int shift) {
        const std::ptrdiff_t row_end = (brick / row_stride_ + 1) * row_stride_;
        for (int n = 0; n < 64 && brick < row_end; n += 4)
            image.words()[word] |= (bricks()[brick++] >> shift & 0xfU) << n;
    });
    return image;
}

}  // namespace dem::shapegen
