// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

namespace dem {

/// 4 x 4 x 4 voxels; bit x + 4 y + 16 z.
using Brick = std::uint64_t;

/// A set of voxels in bricks instead of rows: a surface that crosses a brick has about sixteen
/// voxels in it, but only two or three in a word of a row, so six times fewer words have to be
/// looked at. Bricks follow each other along x, then y, then z. Before the first and after the last
/// layer of bricks there is one without voxels; at the end of a row or a layer the border of the
/// voxel image stands between the voxels of the bricks that are neighbors in memory only.
class BrickImage {
  public:
    explicit BrickImage(const VoxelGrid& grid);
    explicit BrickImage(const VoxelImage& image);
    VoxelImage voxel_image() const;

    /// Bricks between a row and the next, between a layer and the next.
    std::ptrdiff_t row_stride() const { return row_stride_; }
    std::ptrdiff_t layer_stride() const { return layer_stride_; }

    /// Layers with voxels: 1 to layers().
    int layers() const { return layers_; }

    Brick* bricks() { return bricks_.data(); }
    const Brick* bricks() const { return bricks_.data(); }

    bool operator==(const BrickImage&) const = default;

  private:
    VoxelGrid grid_;
    int layers_;
    std::ptrdiff_t row_stride_;
    std::ptrdiff_t layer_stride_;
    std::vector<Brick> bricks_;
};

}  // namespace dem
