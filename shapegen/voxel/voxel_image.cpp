// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/voxel_image.hpp"

#include "common/error.hpp"

#include <bit>

namespace dem::shapegen {

VoxelImage::VoxelImage(const VoxelGrid& grid)
    : grid_(grid),
      row_stride_((grid.size[0] + 63) / 64),
      layer_stride_(row_stride_ * grid.size[1]),
      words_(static_cast<std::size_t>(layer_stride_ * grid.size[2]), 0) {
    DEM_ASSERT(grid.size[0] >= 3 && grid.size[1] >= 3 && grid.size[2] >= 3);
}

void VoxelImage::insert(const Voxel& v) {
    DEM_ASSERT(v[0] > 0 && v[0] < grid_.size[0] - 1 && v[1] > 0 && v[1] < grid_.size[1] - 1 &&
               v[2] > 0 && v[2] < grid_.size[2] - 1);
    words_[index(v)] |= VoxelWord{1} << bit(v);
}

void VoxelImage::insert_run(int first, int last, int j, int k) {
    DEM_ASSERT(first > 0 && last < grid_.size[0] && j > 0 && j < grid_.size[1] - 1 && k > 0 &&
               k < grid_.size[2] - 1);
    if (first >= last) return;
    constexpr VoxelWord all = ~VoxelWord{0};
    const std::size_t begin = index({first, j, k});
    const std::size_t end = index({last - 1, j, k});
    const VoxelWord from_first = all << (first % 64);
    const VoxelWord to_last = all >> (63 - (last - 1) % 64);
    if (begin == end) {
        words_[begin] |= from_first & to_last;
        return;
    }
    words_[begin] |= from_first;
    for (std::size_t i = begin + 1; i < end; ++i) words_[i] = all;
    words_[end] |= to_last;
}

std::size_t VoxelImage::count() const {
    std::size_t count = 0;
    for (const VoxelWord word : words_) count += static_cast<std::size_t>(std::popcount(word));
    return count;
}

std::vector<Voxel> VoxelImage::voxels() const {
    std::vector<Voxel> voxels;
    voxels.reserve(count());
    const VoxelWord* word = words_.data();
    for (int k = 0; k < grid_.size[2]; ++k) {
        for (int j = 0; j < grid_.size[1]; ++j) {
            for (int i = 0; i < grid_.size[0]; i += 64, ++word) {
                for (VoxelWord left = *word; left != 0; left &= left - 1)
                    voxels.push_back({i + std::countr_zero(left), j, k});
            }
        }
    }
    return voxels;
}

}  // namespace dem::shapegen
