// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cell_cover.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dem {
namespace {

constexpr int edge = 4;  // cells of a brick
constexpr int brick_cells = edge * edge * edge;

/// Bricks that a ball reaches along one axis, and squared distances of their cells' centers from
/// the ball's center, in cells.
struct AxisReach {
    int first, last;  ///< bricks, one past the last
    std::vector<std::array<double, edge>> squares;
    std::vector<double> least, most;  ///< of the squares of a brick

    AxisReach(double center, double radius, int bricks) {
        const double low = std::ceil((center - radius - (edge - 1)) / edge);
        const double high = std::floor((center + radius) / edge) + 1.0;
        first = static_cast<int>(std::clamp(low, 0.0, static_cast<double>(bricks)));
        last = static_cast<int>(
            std::clamp(high, static_cast<double>(first), static_cast<double>(bricks)));
        for (int b = first; b < last; ++b) {
            std::array<double, edge> values{};
            for (int i = 0; i < edge; ++i)
                values[static_cast<std::size_t>(i)] = square(edge * b + i - center);
            squares.push_back(values);
            most.push_back(std::max(values.front(), values.back()));
            least.push_back(*std::min_element(values.begin(), values.end()));
        }
    }
};

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
    for (const VoxelWord word : solid_) cells_ += static_cast<std::size_t>(std::popcount(word));
    uncovered_count_ = cells_;
}

/// Calls visit(brick, mask()) for each brick with cells in the ball, in the order of the grid.
/// mask() gives the bits of these cells, which is the costly part.
template <class Visit>
void CellCover::visit_bricks(const Ball& ball, const Visit& visit) const {
    const Vec3 c = (ball.center - grid_.origin) / grid_.spacing;
    const double r = ball.radius / grid_.spacing;
    const double r2 = square(r);
    const AxisReach x(c.x(), r, bricks_[0]);
    const AxisReach y(c.y(), r, bricks_[1]);
    const AxisReach z(c.z(), r, bricks_[2]);
    const auto count = static_cast<std::size_t>(x.last - x.first);
    for (std::size_t k = 0; k < z.least.size(); ++k) {
        for (std::size_t j = 0; j < y.least.size(); ++j) {
            const double least = z.least[k] + y.least[j];
            const double most = z.most[k] + y.most[j];
            if (least > r2) continue;
            const std::size_t row = (static_cast<std::size_t>(z.first + static_cast<int>(k)) *
                                         static_cast<std::size_t>(bricks_[1]) +
                                     static_cast<std::size_t>(y.first + static_cast<int>(j))) *
                                        static_cast<std::size_t>(bricks_[0]) +
                                    static_cast<std::size_t>(x.first);
            for (std::size_t i = 0; i < count; ++i) {
                visit(row + i, [&]() -> VoxelWord {
                    if (least + x.least[i] > r2) return 0;
                    if (most + x.most[i] <= r2) return ~VoxelWord{0};
                    VoxelWord mask = 0;
                    for (int n = brick_cells - edge; n >= 0; n -= edge) {
                        const double d2 = z.squares[k][static_cast<std::size_t>(n / 16)] +
                                          y.squares[j][static_cast<std::size_t>(n / 4 % 4)];
                        unsigned bits = 0;
                        for (unsigned b = 0; b < edge; ++b)
                            bits |= (d2 + x.squares[i][b] <= r2 ? 1U : 0U) << b;
                        mask = mask << edge | bits;
                    }
                    return mask;
                });
            }
        }
    }
}

std::size_t CellCover::gain(const Ball& ball) const {
    std::size_t sum = 0;
    visit_bricks(ball, [&](std::size_t brick, const auto& mask) {
        const VoxelWord word = uncovered_[brick];
        if (word != 0) sum += static_cast<std::size_t>(std::popcount(word & mask()));
    });
    return sum;
}

std::size_t CellCover::exclusive(const Ball& ball) const {
    std::size_t sum = 0;
    visit_bricks(ball, [&](std::size_t brick, const auto& mask) {
        const VoxelWord bits = mask();
        const std::uint16_t* counts = counts_.data() + brick_cells * brick;
        VoxelWord single = 0;
        for (int n = 0; n < brick_cells; ++n) single |= static_cast<VoxelWord>(counts[n] == 1) << n;
        sum += static_cast<std::size_t>(std::popcount(single & bits & solid_[brick]));
    });
    return sum;
}

void CellCover::insert(const Ball& ball) {
    if (counts_.empty()) counts_.assign(brick_cells * solid_.size(), 0);
    mark(ball);
    visit_bricks(ball, [&](std::size_t brick, const auto& mask) {
        const VoxelWord bits = mask();
        std::uint16_t* counts = counts_.data() + brick_cells * brick;
        if (bits == ~VoxelWord{0}) {
            for (int n = 0; n < brick_cells; ++n) ++counts[n];
        } else {
            for (VoxelWord rest = bits; rest != 0; rest &= rest - 1)
                ++counts[std::countr_zero(rest)];
        }
    });
}

void CellCover::mark(const Ball& ball) {
    visit_bricks(ball, [&](std::size_t brick, const auto& mask) {
        VoxelWord& word = uncovered_[brick];
        if (word == 0) return;
        const VoxelWord hit = word & mask();
        uncovered_count_ -= static_cast<std::size_t>(std::popcount(hit));
        word ^= hit;
    });
}

template <class Visit>
void CellCover::take_out(const Ball& ball, const Visit& visit) {
    visit_bricks(ball, [&](std::size_t brick, const auto& mask) {
        const VoxelWord bits = mask();
        if (bits == 0) return;
        std::uint16_t* counts = counts_.data() + brick_cells * brick;
        VoxelWord empty = 0;
        for (int n = 0; n < brick_cells; ++n) {
            counts[n] = static_cast<std::uint16_t>(counts[n] - (bits >> n & 1U));
            empty |= static_cast<VoxelWord>(counts[n] == 0) << n;
        }
        // A ball may reach out of the solid.
        const VoxelWord left = empty & bits & solid_[brick];
        uncovered_[brick] |= left;
        uncovered_count_ += static_cast<std::size_t>(std::popcount(left));
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

}  // namespace dem
