// SPDX-License-Identifier: GPL-3.0-or-later
// Lattice points of a voxel grid in a ball, row by row.
#pragma once

#include "shapegen/clump/ball.hpp"
#include "shapegen/voxel/voxel_image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dem::shapegen {

/// Calls visit(first, last, j, k) for each row (j, k) whose voxel centers first <= i < last lie in
/// the ball. Rows and ends on the border or beyond it are left out.
template <class Visit>
void visit_rows(const VoxelGrid& grid, const Ball& ball, const Visit& visit) {
    const double inverse = 1.0 / grid.spacing;
    const Vec3 c = (ball.center - grid.origin) * inverse;
    const double r2 = square(ball.radius * inverse);
    const auto lowest = [](double x) { return std::max(static_cast<int>(std::ceil(x)), 1); };
    const auto past = [&](double x, std::size_t axis) {
        return std::min(static_cast<int>(std::floor(x)) + 1, grid.size[axis] - 1);
    };
    const double r = std::sqrt(r2);
    for (int k = lowest(c.z() - r); k < past(c.z() + r, 2); ++k) {
        const double disc2 = r2 - square(k - c.z());
        if (disc2 < 0.0) continue;
        const double disc = std::sqrt(disc2);
        for (int j = lowest(c.y() - disc); j < past(c.y() + disc, 1); ++j) {
            const double half2 = disc2 - square(j - c.y());
            if (half2 < 0.0) continue;
            const double half = std::sqrt(half2);
            const int first = lowest(c.x() - half);
            const int last = past(c.x() + half, 0);
            if (first < last) visit(first, last, j, k);
        }
    }
}

/// Calls visit(word index in the row, mask) for each word that has bits first <= i < last.
template <class Visit>
void visit_words(int first, int last, const Visit& visit) {
    const int first_word = first / 64;
    const int last_word = (last - 1) / 64;
    const VoxelWord low = ~VoxelWord{0} << (first % 64);
    const VoxelWord high = ~VoxelWord{0} >> (63 - (last - 1) % 64);
    if (first_word == last_word) {
        visit(first_word, low & high);
        return;
    }
    visit(first_word, low);
    for (int w = first_word + 1; w < last_word; ++w) visit(w, ~VoxelWord{0});
    visit(last_word, high);
}

}  // namespace dem::shapegen
