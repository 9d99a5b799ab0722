// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/select_voxels.hpp"

#include "shapegen/thinning/critical_cliques.hpp"

namespace dem::shapegen {

void Keeper::keep_next_x(Brick voxels, Brick* brick) {
    *brick &= ~((voxels & ~last_x) << 1);
    if ((voxels & last_x) != 0) brick[1] &= ~((voxels & last_x) >> 3);
}

void Keeper::keep_next_y(Brick voxels) const {
    *removable_ &= ~((voxels & ~last_y) << 4);
    if ((voxels & last_y) != 0) removable_[row_stride_] &= ~((voxels & last_y) >> 12);
}

void Keeper::keep_next_xy(Brick voxels) const {
    keep_next_x((voxels & ~last_y) << 4, removable_);
    if ((voxels & last_y) != 0) keep_next_x((voxels & last_y) >> 12, removable_ + row_stride_);
}

void select_from_2_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper) {
    if (removable[i] == 0) return;  // the first voxel of each pair is one of these
    const Neighborhoods n = neighborhoods(x, i);
    const Blocks b = blocks(removable, i);
    keeper.keep(critical_2_cliques<0>(n, b) | critical_2_cliques<1>(n, b) |
                critical_2_cliques<2>(n, b));
}

// Where the first voxel of the block is background, the second is not: around an edge one of both
// diagonals is full.
void select_from_1_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper) {
    const Neighborhoods n = neighborhoods(x, i);
    const Blocks b = blocks(removable, i);
    const Brick along_x = critical_1_cliques<0>(n, b);
    const Brick across_x = critical_1_cliques<1>(n, b) | critical_1_cliques<2>(n, b);
    keeper.keep((along_x | across_x) & x[i]);
    keeper.keep_next_y(along_x & ~x[i]);
    keeper.keep_next_x(across_x & ~x[i]);
}

// The four voxels of lower z are never all background.
void select_from_0_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i,
                           const Keeper& keeper) {
    const Blocks b = blocks(x, i);
    Brick left = critical_0_cliques(b, blocks(removable, i));
    const auto take = [&left](Brick voxels) {
        const Brick taken = left & voxels;
        left &= ~voxels;
        return taken;
    };
    keeper.keep(take(b[Step{0, 0, 0}]));
    keeper.keep_next_x(take(b[Step{1, 0, 0}]));
    keeper.keep_next_y(take(b[Step{0, 1, 0}]));
    keeper.keep_next_xy(left);
}

}  // namespace dem::shapegen
