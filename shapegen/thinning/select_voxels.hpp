// SPDX-License-Identifier: GPL-3.0-or-later
// Which voxel of a critical clique stays: the first in the order of the grid. The cliques looked at
// are those of critical_cliques.hpp whose block begins in one brick.
#pragma once

#include "shapegen/thinning/neighborhoods.hpp"

namespace dem::shapegen {

/// A brick of removable voxels from which those that have to stay are taken; of a layer that no one
/// else writes to.
class Keeper {
  public:
    Keeper(Brick* removable, std::ptrdiff_t row_stride)
        : removable_(removable), row_stride_(row_stride) {}

    /// Keeps the given voxels of the brick, or those one step along x, y or both from them. Nothing
    /// is written beyond the layer, as its last voxels are border.
    void keep(Brick voxels) const { *removable_ &= ~voxels; }
    void keep_next_x(Brick voxels) const { keep_next_x(voxels, removable_); }
    void keep_next_y(Brick voxels) const;
    void keep_next_xy(Brick voxels) const;

  private:
    static void keep_next_x(Brick voxels, Brick* brick);

    Brick* removable_;
    std::ptrdiff_t row_stride_;
};

/// Keeps a voxel of each critical clique of the rank whose block begins in brick i.
void select_from_2_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper);
void select_from_1_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper);
void select_from_0_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper);

}  // namespace dem::shapegen
