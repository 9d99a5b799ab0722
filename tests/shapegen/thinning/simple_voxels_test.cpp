// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/simple_voxels.hpp"

#include "common/random.hpp"
#include "tests/shapegen/thinning/reference_thinning.hpp"

#include <bit>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// A neighborhood's number without the voxel in its middle.
std::uint32_t neighbors_of(std::uint32_t code) {
    return (code & 0x1fffU) | ((code & ~0x1fffU) << 1);
}

TEST(SimpleVoxels, AreInsideAsManyNeighborhoodsAsKnown) {
    // The lowest six bits of a neighborhood's number run over the bits of a word.
    constexpr std::array<Brick, 6> low{0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc, 0xf0f0f0f0f0f0f0f0,
                                       0xff00ff00ff00ff00, 0xffff0000ffff0000, 0xffffffff00000000};
    int simple = 0;
    for (std::uint32_t code = 0; code < 1U << 26; code += 64) {
        Neighborhoods x;
        for (std::size_t n = 0; n < 27; ++n)
            x.words[n] = n < 6 ? low[n] : Brick{0} - (neighbors_of(code) >> n & 1U);
        simple += std::popcount(simple_voxels(x, ~Brick{0}));
    }
    EXPECT_EQ(simple, 25985144);
}

TEST(SimpleVoxels, AreThoseOfTheTwoConditions) {
    Random random(3, 0);
    for (int n = 0; n < 5000; ++n) {
        // Rare and frequent neighbors: most neighborhoods of even chances are not simple.
        const double density = random.uniform(0.05, 0.95);
        Neighborhoods x;
        std::array<std::uint32_t, 64> neighbors{};
        for (std::size_t bit = 0; bit < 64; ++bit) {
            for (std::size_t place = 0; place < 27; ++place) {
                if (place == 13 || random.uniform() > density) continue;
                x.words[place] |= Brick{1} << bit;
                neighbors[bit] |= 1U << place;
            }
        }
        const Brick simple = simple_voxels(x, ~Brick{0});
        for (std::size_t bit = 0; bit < 64; ++bit)
            ASSERT_EQ((simple >> bit & 1U) != 0, test::is_simple(neighbors[bit])) << neighbors[bit];
    }
}

TEST(SimpleVoxels, AreOnlyThoseAskedFor) {
    Random random(5, 0);
    for (int n = 0; n < 1000; ++n) {
        Neighborhoods x;
        for (Brick& word : x.words) word = random.next() & random.next();
        const Brick candidates = random.next();
        EXPECT_EQ(simple_voxels(x, candidates), simple_voxels(x, ~Brick{0}) & candidates);
    }
}

TEST(SimpleVoxels, DoNotDependOnTheVoxelItself) {
    Random random(4, 0);
    Neighborhoods x;
    for (Brick& word : x.words) word = random.next();
    const Brick simple = simple_voxels(x, ~Brick{0});
    x[Step{}] = ~x[Step{}];
    EXPECT_EQ(simple_voxels(x, ~Brick{0}), simple);
}

}  // namespace
}  // namespace dem::shapegen
