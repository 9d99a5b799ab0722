// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/critical_cliques.hpp"

#include "shapegen/thinning/simple_voxels.hpp"
#include "tests/shapegen/thinning/reference_thinning.hpp"
#include "tests/shapegen/thinning/sample_images.hpp"

#include <bit>
#include <cstdlib>
#include <functional>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

/// The critical cliques of some kind whose blocks begin in brick i.
using Cliques =
    std::function<Brick(const BrickView& x, const BrickView& removable, std::ptrdiff_t i)>;

Brick critical_3_cliques(const BrickView& x, const BrickView& removable, std::ptrdiff_t i) {
    return removable[i] & ~simple_voxels(neighborhoods(x, i), x[i]);
}

template <int Axis>
Brick pairs_along(const BrickView& x, const BrickView& removable, std::ptrdiff_t i) {
    return critical_2_cliques<Axis>(neighborhoods(x, i), blocks(removable, i));
}

template <int Axis>
Brick edges_along(const BrickView& x, const BrickView& removable, std::ptrdiff_t i) {
    return critical_1_cliques<Axis>(neighborhoods(x, i), blocks(removable, i));
}

Brick corners(const BrickView& x, const BrickView& removable, std::ptrdiff_t i) {
    return critical_0_cliques(blocks(x, i), blocks(removable, i));
}

const std::array<Cliques, 3> pairs{pairs_along<0>, pairs_along<1>, pairs_along<2>};
const std::array<Cliques, 3> edges{edges_along<0>, edges_along<1>, edges_along<2>};

/// The first voxel of the block of each clique.
VoxelImage find_all(const VoxelImage& X, const VoxelImage& removable, const Cliques& cliques) {
    const BrickImage x(X);
    const BrickImage r(removable);
    BrickImage found(X.grid());
    for (std::ptrdiff_t i = x.layer_stride(); i < (x.layers() + 1) * x.layer_stride(); ++i)
        found.bricks()[i] = cliques(BrickView(x), BrickView(r), i);
    return found.voxel_image();
}

std::size_t count(const VoxelImage& X, const Cliques& cliques) {
    return find_all(X, X, cliques).count();
}

std::size_t count_of_rank(const VoxelImage& X, int rank) {
    if (rank == 3) return count(X, critical_3_cliques);
    if (rank == 0) return count(X, corners);
    std::size_t sum = 0;
    for (const Cliques& cliques : rank == 2 ? pairs : edges) sum += count(X, cliques);
    return sum;
}

bool has_opposite_voxels(const std::vector<Voxel>& clique) {
    for (const Voxel& a : clique)
        for (const Voxel& b : clique)
            if (a[0] != b[0] && a[1] != b[1] && a[2] != b[2]) return true;
    return false;
}

/// Every neighborhood of a clique in one image, one after the other along an axis across the one of
/// the clique: neighborhood n begins at voxel 4 n + 2 with its middle, where the clique lies.
class Lineup {
  public:
    Lineup(int axis, int count)
        : axis_(static_cast<std::size_t>(axis)),
          line_((axis_ + 1) % 3),
          image_({Vec3::Zero(), 1.0, size(count)}) {}

    /// `along` the clique's axis, `line` and `third` in the order of the axes from there.
    Voxel place(int n, int along, int line, int third) const {
        Voxel v{};
        v[axis_] = 2 + along;
        v[line_] = 4 * n + 2 + line;
        v[3 - axis_ - line_] = 2 + third;
        return v;
    }
    VoxelImage& image() { return image_; }

  private:
    std::array<int, 3> size(int count) const {
        std::array<int, 3> size{6, 6, 6};
        size[line_] = 4 * count + 3;
        return size;
    }
    std::size_t axis_, line_;
    VoxelImage image_;
};

TEST(CriticalCliques, OfRank2AreThoseThatCannotBeReduced) {
    for (int axis = 0; axis < 3; ++axis) {
        Lineup lineup(axis, 1 << 16);
        std::vector<bool> reducible(1 << 16);
        for (int n = 0; n < 1 << 16; ++n) {
            std::uint32_t set = 0;
            int bit = 0;
            for (int along = 0; along <= 1; ++along) {
                for (int place = 0; place < 9; ++place) {
                    const int line = place % 3 - 1;
                    const int third = place / 3 - 1;
                    const bool is_clique = line == 0 && third == 0;
                    if (is_clique || ((n >> bit++) & 1) != 0) {
                        lineup.image().insert(lineup.place(n, along, line, third));
                        if (!is_clique) set |= 1U << (13 + line + 3 * third + 9 * along);
                    }
                }
            }
            reducible[static_cast<std::size_t>(n)] = test::is_reducible(set);
        }
        const VoxelImage found =
            find_all(lineup.image(), lineup.image(), pairs[static_cast<std::size_t>(axis)]);
        int regular = 0;
        for (int n = 0; n < 1 << 16; ++n) {
            const bool is_critical = found.contains(lineup.place(n, 0, 0, 0));
            ASSERT_EQ(is_critical, !reducible[static_cast<std::size_t>(n)]) << axis << " " << n;
            regular += is_critical ? 0 : 1;
        }
        EXPECT_EQ(regular, 30156);
    }
}

TEST(CriticalCliques, OfRank1AreThoseThatCannotBeReduced) {
    for (int axis = 0; axis < 3; ++axis) {
        Lineup lineup(axis, 256);
        std::vector<bool> reducible(256);
        for (int n = 0; n < 256; ++n) {
            std::uint32_t set = 0;
            for (int place = 0; place < 12; ++place) {
                const int line = place % 2;
                const int third = place / 2 % 2;
                const int along = place / 4 - 1;
                const int bit = place - (along > 0 ? 4 : 0);
                if (along == 0 ? line != third : ((n >> bit) & 1) != 0) {
                    lineup.image().insert(lineup.place(n, along, line, third));
                    if (along != 0) set |= 1U << (13 + line + 3 * third + 9 * along);
                }
            }
            reducible[static_cast<std::size_t>(n)] = test::is_reducible(set);
        }
        const VoxelImage found =
            find_all(lineup.image(), lineup.image(), edges[static_cast<std::size_t>(axis)]);
        int regular = 0;
        for (int n = 0; n < 256; ++n) {
            const bool is_critical = found.contains(lineup.place(n, 0, 0, 0));
            ASSERT_EQ(is_critical, !reducible[static_cast<std::size_t>(n)]) << axis << " " << n;
            regular += is_critical ? 0 : 1;
        }
        EXPECT_EQ(regular, 30);
    }
}

TEST(CriticalCliques, OfABallWithoutItsCenterAreAsManyAsKnown) {
    const VoxelImage ball = test::image_of({7, 7, 7}, [](int i, int j, int k) {
        const int r = std::abs(i - 3) + std::abs(j - 3) + std::abs(k - 3);
        return r > 0 && r <= 3;
    });
    EXPECT_EQ(ball.count(), 62U);
    EXPECT_EQ(count_of_rank(ball, 3), 18U);
    EXPECT_EQ(count_of_rank(ball, 2), 108U);
    EXPECT_EQ(count_of_rank(ball, 1), 168U);
    // Corners (a, b, c) + 1/2 of an octant with a + b + c <= 2: 1 + 3 + 6. Around the 6 outer ones
    // there are a voxel and three of its face neighbors, no two of them opposite at the corner:
    // 8 x 4 = 32 cliques have two voxels that are.
    EXPECT_EQ(count_of_rank(ball, 0), 80U);
    std::size_t with_opposite = 0;
    for (const std::vector<Voxel>& clique : test::critical_cliques(ball, 0))
        with_opposite += has_opposite_voxels(clique) ? 1 : 0;
    EXPECT_EQ(with_opposite, 32U);
}

TEST(CriticalCliques, AreThoseOfTheDefinition) {
    for (const double density : {0.2, 0.5, 0.8}) {
        const VoxelImage image = test::noise({70, 7, 8}, density, 6);
        for (int rank = 0; rank <= 3; ++rank)
            EXPECT_EQ(count_of_rank(image, rank), test::critical_cliques(image, rank).size())
                << density << " " << rank;
    }
}

// Nothing else keeps the last of these voxels: each is simple, each pair regular.
TEST(CriticalCliques, OfRank0HoldWhatNoOtherCliqueDoes) {
    const VoxelImage corner =
        test::image_of({2, 2, 2}, [](int i, int j, int k) { return i + j + k <= 1; });
    for (int rank = 1; rank <= 3; ++rank) EXPECT_EQ(count_of_rank(corner, rank), 0U);
    EXPECT_EQ(count_of_rank(corner, 0), 1U);
}

TEST(CriticalCliques, WithAKeptVoxelAreLeftOut) {
    const VoxelImage image = test::noise({70, 6, 6}, 0.3, 5);
    for (const Cliques& cliques :
         {Cliques(critical_3_cliques), pairs[0], edges[1], Cliques(corners)}) {
        EXPECT_GT(count(image, cliques), 0U);
        EXPECT_EQ(find_all(image, VoxelImage(image.grid()), cliques).count(), 0U);
    }
}

}  // namespace
}  // namespace dem::shapegen
