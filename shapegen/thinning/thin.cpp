// SPDX-License-Identifier: GPL-3.0-or-later
// [MS Algorithm 1] in the paper's notation: X the voxels, K the ends kept for good, Y the voxels
// kept in this pass. Every step fills whole layers from images it does not write to, so layers can
// be shared out among threads in any way.
#include "shapegen/thinning/thin.hpp"

#include "shapegen/thinning/critical_cliques.hpp"
#include "shapegen/thinning/skeletal_voxels.hpp"

#include <algorithm>
#include <utility>

namespace dem {

namespace {

/// Below, starting the threads takes longer than the work.
constexpr std::ptrdiff_t parallel_threshold = 4096;  // words

/// Calls fill(begin, end) for the words of every layer that is not border; fill may write to them.
template <class Fill>
void for_each_layer(const VoxelImage& image, Fill fill) {
    const int last = image.layers() - 1;
    const std::ptrdiff_t stride = image.layer_stride();
#pragma omp parallel for schedule(static, 1) if (stride * last >= parallel_threshold)
    for (int k = 1; k < last; ++k) fill(k * stride, (k + 1) * stride);
}

void find_interior(const VoxelImage& X, VoxelImage& interior) {
    const WordView x(X);
    VoxelWord* result = interior.words();
    for_each_layer(X, [=](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t i = begin; i < end; ++i) result[i] = interior_voxels(x, i);
    });
}

/// K and the ends of X.
void add_ends(Skeleton kind, const VoxelImage& X, const VoxelImage& interior, VoxelImage& K) {
    if (kind == Skeleton::ultimate) return;
    const WordView x(X);
    const WordView inner(interior);
    VoxelWord* k = K.words();
    for_each_layer(X, [=](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t i = begin; i < end; ++i) {
            if ((x[i] & ~inner[i] & ~k[i]) == 0) continue;
            k[i] |= kind == Skeleton::surface ? surface_ends(x, inner, i) : curve_ends(x, i);
        }
    });
}

/// Y = K and the critical cliques of rank 3; interior voxels are such cliques.
void keep_3_cliques(const VoxelImage& X, const VoxelImage& interior, const VoxelImage& K,
                    VoxelImage& Y) {
    const WordView x(X);
    const WordView inner(interior);
    const WordView ends(K);
    const WordView kept(Y);
    VoxelWord* y = Y.words();
    for_each_layer(X, [=](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t i = begin; i < end; ++i) {
            y[i] = ends[i] | inner[i];
            y[i] |= critical_3_cliques(x, kept, i);
        }
    });
}

/// `result` = Y and one voxel of each of the cliques that select(x, kept, i, selected) finds and
/// adds, as bits, to the words from `selected` on.
template <class Select>
void keep_selected(const VoxelImage& X, const VoxelImage& Y, VoxelImage& result, Select select) {
    const WordView x(X);
    const WordView kept(Y);
    VoxelWord* y = result.words();
    for_each_layer(X, [=](std::ptrdiff_t begin, std::ptrdiff_t end) {
        std::copy(kept.words + begin, kept.words + end, y + begin);
        for (std::ptrdiff_t i = begin; i < end; ++i) select(x, kept, i, y + i);
    });
}

/// Adds the voxels one step on along x. Never writes to another layer: the last row is border.
void add_next(VoxelWord voxels, VoxelWord* word) {
    word[0] |= voxels << 1;
    word[1] |= voxels >> 63;
}

void select_from_2_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i,
                           VoxelWord* selected) {
    if ((x[i] & ~kept[i]) == 0) return;  // the first voxel of a pair is among these
    *selected |= critical_2_cliques<0>(x, kept, i) | critical_2_cliques<1>(x, kept, i) |
                 critical_2_cliques<2>(x, kept, i);
}

/// True if a voxel of X outside `kept` is among the four of lower z of a block that begins in word
/// i. The voxel selected from a clique of rank 1 or 0 always is.
bool may_select_from(const WordView& x, const WordView& kept, std::ptrdiff_t i) {
    const auto removable = [&](std::ptrdiff_t n) { return x[n] & ~kept[n]; };
    const std::ptrdiff_t above = i + x.row_stride;
    return (removable(i) | removable(above) | ((removable(i + 1) | removable(above + 1)) & 1U)) !=
           0;
}

/// The first voxel of the block or, where that is background, the second: around an edge one of
/// both diagonals is full.
void select_from_1_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i,
                           VoxelWord* selected) {
    if (!may_select_from(x, kept, i)) return;
    const VoxelWord along_x = critical_1_cliques<0>(x, kept, i);
    const VoxelWord across_x =
        critical_1_cliques<1>(x, kept, i) | critical_1_cliques<2>(x, kept, i);
    selected[0] |= (along_x | across_x) & x[i];
    selected[x.row_stride] |= along_x & ~x[i];
    add_next(across_x & ~x[i], selected);
}

/// The first voxel of the block; those of lower z are never all background.
void select_from_0_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i,
                           VoxelWord* selected) {
    if (!may_select_from(x, kept, i)) return;
    VoxelWord left = critical_0_cliques(x, kept, i);
    if (left == 0) return;
    const auto take = [&left](VoxelWord voxels) {
        const VoxelWord taken = left & voxels;
        left &= ~voxels;
        return taken;
    };
    selected[0] |= take(x[i]);
    add_next(take(x.at(i, {1, 0, 0})), selected);
    selected[x.row_stride] |= take(x.at(i, {0, 1, 0}));
    add_next(left, selected + x.row_stride);
}

}  // namespace

VoxelImage thin(const VoxelImage& image, Skeleton kind) {
    VoxelImage X = image;
    VoxelImage K(image.grid());
    VoxelImage Y(image.grid());
    VoxelImage spare(image.grid());  // the interior, then the Y to come
    find_interior(X, spare);
    while (true) {
        keep_3_cliques(X, spare, K, Y);
        keep_selected(X, Y, spare, select_from_2_cliques);
        keep_selected(X, spare, Y, select_from_1_cliques);
        keep_selected(X, Y, spare, select_from_0_cliques);
        if (spare == X) return X;
        std::swap(X, spare);
        find_interior(X, spare);
        add_ends(kind, X, spare, K);
    }
}

}  // namespace dem
