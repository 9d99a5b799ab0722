// SPDX-License-Identifier: GPL-3.0-or-later
// [MS Algorithm 1] in the paper's notation: X the voxels, K the ends kept for good, Y the voxels
// kept in this pass. Instead of Y the code has its complement in X, the removable voxels, and looks
// only at bricks that have some. Every step fills whole layers of bricks from images it does not
// write to, so layers can be shared out among threads in any way.
#include "shapegen/thinning/thin.hpp"

#include "common/threads/thread_team.hpp"
#include "shapegen/thinning/select_voxels.hpp"
#include "shapegen/thinning/simple_voxels.hpp"
#include "shapegen/thinning/skeletal_voxels.hpp"

#include <utility>

namespace dem::shapegen {

namespace {

/// Live bricks that take some five microseconds: what one thread works on at a time, at least.
constexpr std::size_t bricks_at_a_time = 200;

using Indices = std::vector<std::ptrdiff_t>;

struct Layer {
    Indices live;    ///< bricks with voxels that are not in K, in the order of the grid
    Indices active;  ///< those with removable voxels in this pass
};

std::vector<Layer> live_layers(const BrickImage& X) {
    std::vector<Layer> layers(static_cast<std::size_t>(X.layers()));
    std::ptrdiff_t i = X.layer_stride();
    for (Layer& layer : layers)
        for (const std::ptrdiff_t end = i + X.layer_stride(); i < end; ++i)
            if (X.bricks()[i] != 0) layer.live.push_back(i);
    return layers;
}

template <class Work>
void for_each_layer(std::vector<Layer>& layers, Work work) {
    std::size_t live = 0;
    for (const Layer& layer : layers) live += layer.live.size();
    const std::size_t layers_at_a_time = 1 + bricks_at_a_time * layers.size() / (live + 1);
    share_each(layers.size(), layers_at_a_time, [&](std::size_t k) { work(layers[k]); });
}

void find_interior(const BrickImage& X, std::vector<Layer>& layers, BrickImage& interior) {
    const BrickView x(X);
    Brick* result = interior.bricks();
    for_each_layer(layers, [=](const Layer& layer) {
        for (const std::ptrdiff_t i : layer.live) result[i] = interior_voxels(x, i);
    });
}

/// Adds the ends of X to K; bricks without other voxels are done and their interior is empty.
void add_ends(Skeleton kind, const BrickImage& X, const BrickImage& interior,
              std::vector<Layer>& layers, BrickImage& K) {
    const BrickView x(X);
    const BrickView inner(interior);
    Brick* k = K.bricks();
    for_each_layer(layers, [=](Layer& layer) {
        for (const std::ptrdiff_t i : layer.live) {
            if ((x[i] & ~inner[i] & ~k[i]) == 0) continue;
            if (kind == Skeleton::surface) k[i] |= surface_ends(x, inner, i);
            if (kind == Skeleton::curve) k[i] |= curve_ends(x, i);
        }
        std::erase_if(layer.live, [=](std::ptrdiff_t i) { return x[i] == k[i]; });
    });
}

/// Rank 3: the simple voxels of X that are not in K; interior voxels never are simple.
void find_removable(const BrickImage& X, const BrickImage& interior, const BrickImage& K,
                    std::vector<Layer>& layers, BrickImage& removable) {
    const BrickView x(X);
    const BrickView inner(interior);
    const BrickView ends(K);
    Brick* result = removable.bricks();
    for_each_layer(layers, [=](Layer& layer) {
        layer.active.clear();
        for (const std::ptrdiff_t i : layer.live) {
            const Brick candidates = x[i] & ~inner[i] & ~ends[i];
            if (candidates == 0) continue;
            result[i] = simple_voxels(neighborhoods(x, i), candidates);
            if (result[i] != 0) layer.active.push_back(i);
        }
    });
}

/// True if a removable voxel is among the four of lower z of a block that begins in brick i. The
/// voxel selected from a clique always is.
bool may_select_from(const BrickView& removable, std::ptrdiff_t i) {
    const std::ptrdiff_t above = i + removable.row_stride;
    return (removable[i] | (removable[i + 1] & first_x) | (removable[above] & first_y) |
            (removable[above + 1] & first_x & first_y)) != 0;
}

/// Calls visit(i) once for each brick i in which a block with a removable voxel may begin: brick
/// `active` and the three before it along x and y that reach into it, unless another brick that
/// they reach into comes first.
template <class Visit>
void for_each_origin(const BrickView& removable, std::ptrdiff_t active, Visit visit) {
    const std::array<std::ptrdiff_t, 4> reach{0, 1, removable.row_stride, removable.row_stride + 1};
    if (removable[active] == 0) return;
    for (std::size_t n = 0; n < reach.size(); ++n) {
        const std::ptrdiff_t i = active - reach[n];
        bool is_first = true;
        for (std::size_t m = 0; m < n; ++m) is_first = is_first && removable[i + reach[m]] == 0;
        if (is_first && may_select_from(removable, i)) visit(i);
    }
}

/// Ranks 2 to 0: `result` = the removable voxels without one of each critical clique.
template <class Select>
void keep_selected(const BrickImage& X, const BrickImage& removable, std::vector<Layer>& layers,
                   BrickImage& result, Select select) {
    const BrickView x(X);
    const BrickView in(removable);
    Brick* out = result.bricks();
    for_each_layer(layers, [=](const Layer& layer) {
        for (const std::ptrdiff_t i : layer.active) out[i] = in[i];
        for (const std::ptrdiff_t active : layer.active)
            for_each_origin(in, active, [=](std::ptrdiff_t i) {
                select(x, in, i, Keeper(out + i, in.row_stride));
            });
    });
}

/// X = Y; false if they are the same. Leaves no removable voxels.
bool remove_voxels(BrickImage& removable, BrickImage& spare, const std::vector<Layer>& layers,
                   BrickImage& X) {
    Brick any = 0;
    for (const Layer& layer : layers) {
        for (const std::ptrdiff_t i : layer.active) {
            X.bricks()[i] &= ~removable.bricks()[i];
            any |= removable.bricks()[i];
            removable.bricks()[i] = 0;
            spare.bricks()[i] = 0;
        }
    }
    return any != 0;
}

}  // namespace

VoxelImage thin(const VoxelImage& image, Skeleton kind) {
    BrickImage X(image);
    BrickImage K(image.grid());
    BrickImage interior(image.grid());
    BrickImage removable(image.grid());
    BrickImage spare(image.grid());
    std::vector<Layer> layers = live_layers(X);
    find_interior(X, layers, interior);
    while (true) {
        find_removable(X, interior, K, layers, removable);
        keep_selected(X, removable, layers, spare, select_from_2_cliques);
        keep_selected(X, spare, layers, removable, select_from_1_cliques);
        keep_selected(X, removable, layers, spare, select_from_0_cliques);
        if (!remove_voxels(spare, removable, layers, X)) return X.voxel_image();
        find_interior(X, layers, interior);
        add_ends(kind, X, interior, layers, K);
    }
}

}  // namespace dem::shapegen
