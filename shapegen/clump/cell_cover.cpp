// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cell_cover.hpp"

#include "shapegen/clump/ball_rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace dem::shapegen {
namespace {

constexpr int edge = 4;  // cells of a brick
constexpr std::size_t brick_rows = edge * std::size_t{edge};
constexpr int brick_cells = edge * edge * edge;
constexpr int block_edge = 2 * edge;  // cells of a block

/// Squared distances of the cells of a row of four, one cell apart, from a point; `first` is the
/// offset of the first one, all in cells.
struct CellSquares {
    std::array<double, edge> values;
    double least, most;

    explicit CellSquares(double first) {
        for (int i = 0; i < edge; ++i) values[static_cast<std::size_t>(i)] = square(first + i);
        least = *std::min_element(values.begin(), values.end());
        most = std::max(values.front(), values.back());
    }
};

/// A range of bricks along an axis, one past the last.
struct BrickRange {
    int first, last;
};

/// The bricks, or blocks, of so many cells that have one within `half` cells of a point.
template <int size = edge>
inline BrickRange bricks_with_any(double center, double half, int bricks) {
    const int low = static_cast<int>(std::ceil((center - half - (size - 1)) / size));
    const int high = static_cast<int>(std::floor((center + half) / size)) + 1;
    const int first = std::clamp(low, 0, bricks);
    return {first, std::clamp(high, first, bricks)};
}

/// Those of the bricks that have all their cells within `half` cells.
inline BrickRange bricks_with_all(double center, double half, const BrickRange& any) {
    const int low = static_cast<int>(std::ceil((center - half) / edge));
    const int high = static_cast<int>(std::floor((center + half - (edge - 1)) / edge)) + 1;
    const int first = std::clamp(low, any.first, any.last);
    return {first, std::clamp(high, first, any.last)};
}

/// Bits of the cells of a brick whose squared distance along x is at most what y and z leave.
VoxelWord brick_mask(const std::array<float, brick_rows>& left, double first_x) {
    const auto first = static_cast<float>(first_x);
    VoxelWord mask = 0;
#ifdef __SSE2__
    const __m128 x = _mm_add_ps(_mm_set1_ps(first), _mm_setr_ps(0.0F, 1.0F, 2.0F, 3.0F));
    const __m128 squares = _mm_mul_ps(x, x);
    for (std::size_t n = brick_rows; n-- > 0;) {
        const __m128 is_in = _mm_cmple_ps(squares, _mm_set1_ps(left[n]));
        mask = mask << edge | static_cast<unsigned>(_mm_movemask_ps(is_in));
    }
#else
    for (std::size_t n = brick_rows; n-- > 0;) {
        for (int i = edge; i-- > 0;)
            mask = mask << 1 | (square(first + static_cast<float>(i)) <= left[n] ? 1U : 0U);
    }
#endif
    return mask;
}

}  // namespace

CellCover::CellCover(const VoxelImage& solid) : grid_(solid.grid()) {
    for (std::size_t a = 0; a < 3; ++a) bricks_[a] = (grid_.size[a] + edge - 1) / edge;
    solid_.assign(static_cast<std::size_t>(bricks_[0]) * static_cast<std::size_t>(bricks_[1]) *
                      static_cast<std::size_t>(bricks_[2]),
                  0);
    const auto row_words = static_cast<std::size_t>((grid_.size[0] + 63) / 64);
    const VoxelWord* words = solid.words();
    for (int k = 0; k < grid_.size[2]; ++k) {
        for (int j = 0; j < grid_.size[1]; ++j, words += row_words) {
            VoxelWord* row = solid_.data() + static_cast<std::size_t>(
                                                 (k / edge * bricks_[1] + j / edge) * bricks_[0]);
            const int shift = edge * (edge * (k % edge) + j % edge);
            for (int b = 0; b < bricks_[0]; ++b)
                row[b] |= (words[b / 16] >> (edge * (b % 16)) & 0xfU) << shift;
        }
    }
    uncovered_ = solid_;
    row_words_ = static_cast<std::size_t>((bricks_[0] + 63) / 64);
    filled_.assign(
        row_words_ * static_cast<std::size_t>(bricks_[1]) * static_cast<std::size_t>(bricks_[2]),
        0);
    for (std::size_t brick = 0; brick < solid_.size(); ++brick)
        if (solid_[brick] != 0) word_of(filled_, brick) |= bit_of(brick);
    open_ = filled_;
    for (const VoxelWord word : solid_) cells_ += static_cast<std::size_t>(std::popcount(word));
    uncovered_count_ = cells_;
    for (std::size_t a = 0; a < 3; ++a) blocks_[a] = (bricks_[a] + 1) / 2;
    block_uncovered_.assign(static_cast<std::size_t>(blocks_[0]) *
                                static_cast<std::size_t>(blocks_[1]) *
                                static_cast<std::size_t>(blocks_[2]),
                            0);
    for (std::size_t brick = 0; brick < solid_.size(); ++brick)
        block_uncovered_[block_of(brick)] +=
            static_cast<std::uint16_t>(std::popcount(solid_[brick]));
}

std::size_t CellCover::block_of(std::size_t brick) const {
    const auto nx = static_cast<std::size_t>(bricks_[0]);
    const auto ny = static_cast<std::size_t>(bricks_[1]);
    return (brick / nx / ny / 2 * static_cast<std::size_t>(blocks_[1]) + brick / nx % ny / 2) *
               static_cast<std::size_t>(blocks_[0]) +
           brick % nx / 2;
}

VoxelWord& CellCover::word_of(BrickBits& bits, std::size_t brick) const {
    const auto nx = static_cast<std::size_t>(bricks_[0]);
    return bits[brick / nx * row_words_ + brick % nx / 64];
}

VoxelWord CellCover::bit_of(std::size_t brick) const {
    return VoxelWord{1} << (brick % static_cast<std::size_t>(bricks_[0]) % 64);
}

/// Calls visit(brick, mask()) for each brick of `which` with cells in the ball, and some that just
/// miss it, in the order of the grid. mask() gives the bits of these cells.
template <class Visit>
void CellCover::visit_bricks(const Ball& ball, const BrickBits& which, const Visit& visit) const {
    const Vec3 c = (ball.center - grid_.origin) / grid_.spacing;
    const double r = ball.radius / grid_.spacing;
    const double r2 = square(r);
    const BrickRange layers = bricks_with_any(c.z(), r, bricks_[2]);
    for (int k = layers.first; k < layers.last; ++k) {
        const CellSquares z(edge * k - c.z());
        if (z.least > r2) continue;
        const BrickRange rows = bricks_with_any(c.y(), std::sqrt(r2 - z.least), bricks_[1]);
        for (int j = rows.first; j < rows.last; ++j) {
            const CellSquares y(edge * j - c.y());
            const double least = z.least + y.least;
            if (least > r2) continue;
            const BrickRange any = bricks_with_any(c.x(), std::sqrt(r2 - least), bricks_[0]);
            if (any.first == any.last) continue;
            const std::size_t row =
                static_cast<std::size_t>(k) * static_cast<std::size_t>(bricks_[1]) +
                static_cast<std::size_t>(j);
            const double most = z.most + y.most;
            BrickRange all{0, 0};
            std::array<float, brick_rows> left;  // of the squared radius for x
            bool is_ready = false;
            visit_words(any.first, any.last, [&](int word, VoxelWord range) {
                VoxelWord rest = which[row * row_words_ + static_cast<std::size_t>(word)] & range;
                if (rest == 0) return;
                if (!is_ready) {
                    is_ready = true;
                    if (most <= r2) all = bricks_with_all(c.x(), std::sqrt(r2 - most), any);
                    for (std::size_t n = 0; n < left.size(); ++n)
                        left[n] = static_cast<float>(r2 - z.values[n / edge] - y.values[n % edge]);
                }
                for (; rest != 0; rest &= rest - 1) {
                    const int i = 64 * word + std::countr_zero(rest);
                    visit(row * static_cast<std::size_t>(bricks_[0]) + static_cast<std::size_t>(i),
                          [&] {
                              return i >= all.first && i < all.last
                                         ? ~VoxelWord{0}
                                         : brick_mask(left, edge * i - c.x());
                          });
                }
            });
        }
    }
}

std::size_t CellCover::gain(const Ball& ball) const {
    std::size_t sum = 0;
    visit_bricks(ball, open_, [&](std::size_t brick, const auto& mask) {
        sum += static_cast<std::size_t>(std::popcount(uncovered_[brick] & mask()));
    });
    return sum;
}

std::size_t CellCover::gain_bound(const Ball& ball) const {
    const Vec3 c = (ball.center - grid_.origin) / grid_.spacing;
    const double r = ball.radius / grid_.spacing;
    const double r2 = square(r);
    // From the nearest cell of a row of blocks.
    const auto nearest = [](int block, double x) {
        const double first = block_edge * block - x;
        return square(std::max({first, -(first + (block_edge - 1)), 0.0}));
    };
    std::size_t sum = 0;
    const BrickRange layers = bricks_with_any<block_edge>(c.z(), r, blocks_[2]);
    for (int k = layers.first; k < layers.last; ++k) {
        const double disc2 = r2 - nearest(k, c.z());
        if (disc2 < 0.0) continue;
        const BrickRange rows = bricks_with_any<block_edge>(c.y(), std::sqrt(disc2), blocks_[1]);
        for (int j = rows.first; j < rows.last; ++j) {
            const double half2 = disc2 - nearest(j, c.y());
            if (half2 < 0.0) continue;
            const BrickRange any = bricks_with_any<block_edge>(c.x(), std::sqrt(half2), blocks_[0]);
            const std::uint16_t* row =
                block_uncovered_.data() +
                static_cast<std::size_t>(k * blocks_[1] + j) * static_cast<std::size_t>(blocks_[0]);
            for (int i = any.first; i < any.last; ++i) sum += row[i];
        }
    }
    return sum;
}

std::size_t CellCover::exclusive(const Ball& ball) const {
    std::size_t sum = 0;
    visit_bricks(ball, filled_, [&](std::size_t brick, const auto& mask) {
        const unsigned whole = brick_counts_[brick];
        if (whole > 1) return;
        const VoxelWord bits = mask();
        // The cells that no other ball counts: it counts itself either here or there.
        const auto alone = static_cast<std::uint16_t>(bits == ~VoxelWord{0} ? 0 : 1);
        if (whole + alone != 1) return;
        const std::uint16_t* counts = cell_counts_.data() + brick_cells * brick;
        VoxelWord single = 0;
        for (int n = 0; n < brick_cells; ++n)
            single |= static_cast<VoxelWord>(counts[n] == alone) << n;
        sum += static_cast<std::size_t>(std::popcount(single & bits & solid_[brick]));
    });
    return sum;
}

void CellCover::insert(const Ball& ball) {
    if (brick_counts_.empty()) {
        brick_counts_.assign(solid_.size(), 0);
        cell_counts_.assign(brick_cells * solid_.size(), 0);
    }
    mark(ball);
    visit_bricks(ball, filled_, [&](std::size_t brick, const auto& mask) {
        const VoxelWord bits = mask();
        if (bits == ~VoxelWord{0}) {
            ++brick_counts_[brick];
            return;
        }
        std::uint16_t* counts = cell_counts_.data() + brick_cells * brick;
        for (VoxelWord rest = bits; rest != 0; rest &= rest - 1) ++counts[std::countr_zero(rest)];
    });
}

void CellCover::mark(const Ball& ball) {
    visit_bricks(ball, open_, [&](std::size_t brick, const auto& mask) {
        VoxelWord& word = uncovered_[brick];
        const VoxelWord hit = word & mask();
        const int count = std::popcount(hit);
        uncovered_count_ -= static_cast<std::size_t>(count);
        block_uncovered_[block_of(brick)] -= static_cast<std::uint16_t>(count);
        word ^= hit;
        if (word == 0) word_of(open_, brick) &= ~bit_of(brick);
    });
}

template <class Visit>
void CellCover::take_out(const Ball& ball, const Visit& visit) {
    visit_bricks(ball, filled_, [&](std::size_t brick, const auto& mask) {
        const VoxelWord bits = mask();
        if (bits == 0) return;
        std::uint16_t* counts = cell_counts_.data() + brick_cells * brick;
        if (bits == ~VoxelWord{0}) {
            --brick_counts_[brick];
        } else {
            for (VoxelWord rest = bits; rest != 0; rest &= rest - 1)
                --counts[std::countr_zero(rest)];
        }
        if (brick_counts_[brick] > 0) return;
        VoxelWord empty = 0;
        for (int n = 0; n < brick_cells; ++n) empty |= static_cast<VoxelWord>(counts[n] == 0) << n;
        // A ball may reach out of the solid.
        const VoxelWord left = empty & bits & solid_[brick];
        if (left == 0) return;
        uncovered_[brick] |= left;
        word_of(open_, brick) |= bit_of(brick);
        const int count = std::popcount(left);
        uncovered_count_ += static_cast<std::size_t>(count);
        block_uncovered_[block_of(brick)] += static_cast<std::uint16_t>(count);
        for (VoxelWord rest = left; rest != 0; rest &= rest - 1)
            visit(brick, std::countr_zero(rest));
    });
}

Vec3 CellCover::center(std::size_t brick, int bit) const {
    const auto nx = static_cast<std::size_t>(bricks_[0]);
    const auto ny = static_cast<std::size_t>(bricks_[1]);
    const auto at = [](std::size_t b, int cell) { return edge * static_cast<int>(b) + cell; };
    return grid_.center({at(brick % nx, bit % edge), at(brick / nx % ny, bit / edge % edge),
                         at(brick / nx / ny, bit / (edge * edge))});
}

void CellCover::erase(const Ball& ball, std::vector<Vec3>& uncovered_centers) {
    take_out(ball,
             [&](std::size_t brick, int bit) { uncovered_centers.push_back(center(brick, bit)); });
}

void CellCover::erase(const Ball& ball) {
    take_out(ball, [](std::size_t, int) {});
}

}  // namespace dem::shapegen
