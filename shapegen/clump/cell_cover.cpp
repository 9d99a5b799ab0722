// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cell_cover.hpp"

namespace dem {

CellCover::CellCover(const VoxelImage& solid)
    : row_words_(static_cast<std::size_t>((solid.grid().size[0] + 63) / 64)),
      solid_(solid),
      uncovered_(solid),
      cells_(solid.count()),
      uncovered_count_(cells_) {
    const auto& size = solid.grid().size;
    counts_.assign(
        64 * row_words_ * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]), 0);
}

std::size_t CellCover::gain(const Ball& ball) const {
    std::size_t sum = 0;
    visit_rows(uncovered_.grid(), ball, [&](int first, int last, int j, int k) {
        const VoxelWord* words = uncovered_.words() + row(j, k);
        visit_words(first, last, [&](int w, VoxelWord mask) {
            sum += static_cast<std::size_t>(std::popcount(words[w] & mask));
        });
    });
    return sum;
}

std::size_t CellCover::exclusive(const Ball& ball) const {
    std::size_t sum = 0;
    visit_rows(uncovered_.grid(), ball, [&](int first, int last, int j, int k) {
        const std::uint16_t* counts = counts_.data() + 64 * row(j, k);
        int ones = 0;
        for (int i = first; i < last; ++i) ones += counts[i] == 1 ? 1 : 0;
        sum += static_cast<std::size_t>(ones);
    });
    return sum;
}

void CellCover::insert(const Ball& ball) {
    mark(ball);
    visit_rows(uncovered_.grid(), ball, [&](int first, int last, int j, int k) {
        std::uint16_t* counts = counts_.data() + 64 * row(j, k);
        for (int i = first; i < last; ++i) ++counts[i];
    });
}

void CellCover::mark(const Ball& ball) {
    visit_rows(uncovered_.grid(), ball, [&](int first, int last, int j, int k) {
        VoxelWord* words = uncovered_.words() + row(j, k);
        visit_words(first, last, [&](int w, VoxelWord mask) {
            uncovered_count_ -= static_cast<std::size_t>(std::popcount(words[w] & mask));
            words[w] &= ~mask;
        });
    });
}

template <class Visit>
void CellCover::take_out(const Ball& ball, const Visit& visit) {
    visit_rows(uncovered_.grid(), ball, [&](int first, int last, int j, int k) {
        std::uint16_t* counts = counts_.data() + 64 * row(j, k);
        VoxelWord* words = uncovered_.words() + row(j, k);
        const VoxelWord* solid = solid_.words() + row(j, k);
        for (int i = first; i < last; ++i) {
            if (--counts[i] != 0) continue;
            const VoxelWord bit = solid[i / 64] & (VoxelWord{1} << (i % 64));
            if (bit == 0) continue;  // a ball that reaches out of the solid
            words[i / 64] |= bit;
            ++uncovered_count_;
            visit(Voxel{i, j, k});
        }
    });
}

void CellCover::erase(const Ball& ball, std::vector<Vec3>& uncovered_centers) {
    take_out(ball,
             [&](const Voxel& v) { uncovered_centers.push_back(uncovered_.grid().center(v)); });
}

void CellCover::erase(const Ball& ball) {
    take_out(ball, [](const Voxel&) {});
}

}  // namespace dem
