// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/critical_cliques.hpp"

#include "shapegen/thinning/simple_voxels.hpp"

namespace dem {

namespace {

/// True where exactly one of the words is.
template <std::size_t N>
VoxelWord exactly_one(const std::array<VoxelWord, N>& words) {
    VoxelWord one = 0;
    VoxelWord more = 0;
    for (const VoxelWord w : words) {
        more |= one & w;
        one |= w;
    }
    return one & ~more;
}

/// Ring of 8 around a voxel in the plane of u and v; edge neighbors have even places.
constexpr std::array<Step, 8> ring(Step u, Step v) {
    return {u, u + v, v, -u + v, -u, -u + -v, -v, u + -v};
}

/// The two axes across an edge, the one that comes first in the order of the voxels first.
constexpr std::array<Step, 2> across(int axis) {
    return {unit_steps[axis == 0 ? 1 : 0], unit_steps[axis == 2 ? 1 : 2]};
}

}  // namespace

VoxelWord critical_3_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i) {
    const VoxelWord candidates = x[i] & ~kept[i];
    if (candidates == 0) return 0;
    Neighborhoods neighbors{};
    std::size_t n = 0;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) neighbors[n++] = x.at(i, {dx, dy, dz});
    return candidates & ~simple_voxels(neighbors);
}

// The 16 voxels that touch both lie in two rings, one around each. What both rings hold, laid one
// on the other, can be shrunk to a point when it is one arc: when going around, a gap in the ring
// of edge and corner places begins exactly once (the connectivity number of Yokoi).
template <int Axis>
VoxelWord critical_2_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i) {
    constexpr Step along = unit_steps[Axis];
    constexpr std::array<Step, 2> side = across(Axis);
    constexpr std::array<Step, 8> around = ring(side[0], side[1]);
    const VoxelWord pairs = x[i] & ~kept[i] & x.at(i, along) & ~kept.at(i, along);
    if (pairs == 0) return 0;
    std::array<VoxelWord, 8> r{};
    for (std::size_t n = 0; n < 8; ++n) r[n] = x.at(i, around[n]) | x.at(i, around[n] + along);
    std::array<VoxelWord, 4> gap{};
    for (std::size_t n = 0; n < 4; ++n) gap[n] = ~r[2 * n] & (r[2 * n + 1] | r[(2 * n + 2) % 8]);
    return pairs & ~exactly_one(gap);
}

// The voxels that touch the whole edge lie in the blocks before and after it. Each block can be
// shrunk to a point if it is not empty, and no voxel of one touches one of the other.
template <int Axis>
VoxelWord critical_1_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i) {
    constexpr Step along = unit_steps[Axis];
    constexpr std::array<Step, 2> side = across(Axis);
    constexpr std::array<Step, 4> block{Step{}, side[0], side[1], side[0] + side[1]};
    const auto diagonal =
        (x.at(i, block[0]) & x.at(i, block[3])) | (x.at(i, block[1]) & x.at(i, block[2]));
    if (diagonal == 0) return 0;
    VoxelWord before = 0;
    VoxelWord after = 0;
    VoxelWord chosen = 0;
    for (const Step& step : block) {
        before |= x.at(i, step + -along);
        after |= x.at(i, step + along);
        chosen |= kept.at(i, step);
    }
    return diagonal & ~chosen & ~(before ^ after);
}

VoxelWord critical_0_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i) {
    std::array<VoxelWord, 6> half{};  // of the block, on either side of each axis
    VoxelWord chosen = 0;
    for (int dz = 0; dz <= 1; ++dz) {
        for (int dy = 0; dy <= 1; ++dy) {
            for (int dx = 0; dx <= 1; ++dx) {
                const VoxelWord word = x.at(i, {dx, dy, dz});
                half[static_cast<std::size_t>(dx)] |= word;
                half[static_cast<std::size_t>(2 + dy)] |= word;
                half[static_cast<std::size_t>(4 + dz)] |= word;
                chosen |= kept.at(i, {dx, dy, dz});
            }
        }
    }
    return half[0] & half[1] & half[2] & half[3] & half[4] & half[5] & ~chosen;
}

template VoxelWord critical_2_cliques<0>(const WordView&, const WordView&, std::ptrdiff_t);
template VoxelWord critical_2_cliques<1>(const WordView&, const WordView&, std::ptrdiff_t);
template VoxelWord critical_2_cliques<2>(const WordView&, const WordView&, std::ptrdiff_t);
template VoxelWord critical_1_cliques<0>(const WordView&, const WordView&, std::ptrdiff_t);
template VoxelWord critical_1_cliques<1>(const WordView&, const WordView&, std::ptrdiff_t);
template VoxelWord critical_1_cliques<2>(const WordView&, const WordView&, std::ptrdiff_t);

}  // namespace dem
