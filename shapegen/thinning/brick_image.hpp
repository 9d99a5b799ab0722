// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

namespace dem::shapegen {

/// 4 x 4 x 4 voxels; bit x + 4 y + 16 z.
using Brick = std::uint64_t;

/// A set of voxels in bricks instead of rows: of the bunny at d_eq / 100, a brick with candidates
/// for removal has 10.7 of them, 64 voxels of a row have 2.9, so that much less has to be looked
/// at. Bricks follow each other along x, then y, then z. Before the first and after the last layer
/// there is one without voxels, and a margin for the neighbors of its own; at the end of a row or a
/// layer the border of the voxel image stands between bricks that are neighbors in memory only.
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

    Brick* bricks() { return bricks_.data() + margin(); }
    const Brick* bricks() const { return bricks_.data() + margin(); }

    bool operator==(const BrickImage&) const = default;

  private:
    /// The first neighbor of a brick is a layer, a row and a brick before it.
    std::ptrdiff_t margin() const { return row_stride_ + 1; }

    VoxelGrid grid_;
    int layers_;
    std::ptrdiff_t row_stride_;
    std::ptrdiff_t layer_stride_;
    std::vector<Brick> bricks_;
};

}  // namespace dem::shapegen
