// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/critical_cliques.hpp"

namespace dem::shapegen {

namespace {

/// True where exactly one of the words is.
template <std::size_t N>
Brick exactly_one(const std::array<Brick, N>& words) {
    Brick one = 0;
    Brick more = 0;
    for (const Brick w : words) {
        more |= one & w;
        one |= w;
    }
    return one & ~more;
}

/// The 8 steps around an axis; those to face neighbors have even places.
constexpr std::array<Step, 8> ring(Step u, Step v) {
    return {u, u + v, v, -u + v, -u, -u + -v, -v, u + -v};
}

/// The two axes across another, the one that comes first in the order of the voxels first.
constexpr std::array<Step, 2> across(int axis) {
    return {unit_steps[axis == 0 ? 1 : 0], unit_steps[axis == 2 ? 1 : 2]};
}

}  // namespace

// The 16 voxels that touch both lie in two rings, one around each. What both rings hold, laid one
// on the other, can be shrunk to a point when it is one arc: when going around, a gap between face
// neighbors begins exactly once (the connectivity number of Yokoi).
template <int Axis>
Brick critical_2_cliques(const Neighborhoods& x, const Blocks& removable) {
    constexpr Step along = unit_steps[Axis];
    constexpr std::array<Step, 2> side = across(Axis);
    constexpr std::array<Step, 8> around = ring(side[0], side[1]);
    std::array<Brick, 8> r{};
    for (std::size_t n = 0; n < 8; ++n) r[n] = x[around[n]] | x[around[n] + along];
    std::array<Brick, 4> gap{};
    for (std::size_t n = 0; n < 4; ++n) gap[n] = ~r[2 * n] & (r[2 * n + 1] | r[(2 * n + 2) % 8]);
    return removable[Step{}] & removable[along] & ~exactly_one(gap);
}

// The voxels that touch the whole edge lie in the blocks before and after it. Each block can be
// shrunk to a point if it is not empty, and no voxel of one touches one of the other.
template <int Axis>
Brick critical_1_cliques(const Neighborhoods& x, const Blocks& removable) {
    constexpr Step along = unit_steps[Axis];
    constexpr std::array<Step, 2> side = across(Axis);
    constexpr std::array<Step, 4> block{Step{}, side[0], side[1], side[0] + side[1]};
    const Brick diagonal = (x[block[0]] & x[block[3]]) | (x[block[1]] & x[block[2]]);
    Brick before = 0;
    Brick after = 0;
    Brick chosen = 0;
    for (const Step& step : block) {
        before |= x[step + -along];
        after |= x[step + along];
        chosen |= x[step] & ~removable[step];
    }
    return diagonal & ~chosen & ~(before ^ after);
}

Brick critical_0_cliques(const Blocks& x, const Blocks& removable) {
    std::array<Brick, 6> half{};  // of the block, on either side of each axis
    Brick chosen = 0;
    for (std::size_t n = 0; n < 8; ++n) {
        half[n & 1U] |= x.words[n];
        half[2 + (n >> 1 & 1U)] |= x.words[n];
        half[4 + (n >> 2)] |= x.words[n];
        chosen |= x.words[n] & ~removable.words[n];
    }
    return half[0] & half[1] & half[2] & half[3] & half[4] & half[5] & ~chosen;
}

template Brick critical_2_cliques<0>(const Neighborhoods&, const Blocks&);
template Brick critical_2_cliques<1>(const Neighborhoods&, const Blocks&);
template Brick critical_2_cliques<2>(const Neighborhoods&, const Blocks&);
template Brick critical_1_cliques<0>(const Neighborhoods&, const Blocks&);
template Brick critical_1_cliques<1>(const Neighborhoods&, const Blocks&);
template Brick critical_1_cliques<2>(const Neighborhoods&, const Blocks&);

}  // namespace dem::shapegen
