// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::shapegen {

/// 64 voxels of a row; bit b of word w is voxel 64 w + b.
using VoxelWord = std::uint64_t;

/// A set of voxels of a grid, one bit each, rows padded to whole words. Invariant: the border and
/// the padding are background.
class VoxelImage {
  public:
    /// Background everywhere.
    explicit VoxelImage(const VoxelGrid& grid);

    const VoxelGrid& grid() const { return grid_; }

    bool contains(const Voxel& v) const { return ((words_[index(v)] >> bit(v)) & 1U) != 0; }

    /// The voxel must not be on the border.
    void insert(const Voxel& v);
    void erase(const Voxel& v) { words_[index(v)] &= ~(VoxelWord{1} << bit(v)); }

    /// Inserts the voxels first <= i < last of the row (j, k), none of them on the border.
    void insert_run(int first, int last, int j, int k);

    std::size_t count() const;

    /// In the order of the grid: x fastest, then y, then z.
    std::vector<Voxel> voxels() const;

    /// Row after row in the order of the grid, (size[0] + 63) / 64 words each.
    /// Whoever writes keeps the border and the padding at zero.
    VoxelWord* words() { return words_.data(); }
    const VoxelWord* words() const { return words_.data(); }

    bool operator==(const VoxelImage&) const = default;

  private:
    std::size_t index(const Voxel& v) const {
        return static_cast<std::size_t>(v[2] * layer_stride_ + v[1] * row_stride_ + v[0] / 64);
    }
    static int bit(const Voxel& v) { return v[0] % 64; }

    VoxelGrid grid_;
    std::ptrdiff_t row_stride_;
    std::ptrdiff_t layer_stride_;
    std::vector<VoxelWord> words_;
};

}  // namespace dem::shapegen
