// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/neighborhoods.hpp"

namespace dem::shapegen {

// One axis after the other: steps along y are taken from what the steps along x gave, and steps
// along z from those.
Neighborhoods neighborhoods(const BrickView& view, std::ptrdiff_t i) {
    std::array<std::array<Brick, 9>, 3> layers{};  // layer of bricks; place by the steps in x and y
    for (std::size_t dz = 0; dz < 3; ++dz) {
        std::array<std::array<Brick, 3>, 3> rows{};
        for (std::size_t dy = 0; dy < 3; ++dy) {
            const Brick* b = view.bricks + i +
                             (static_cast<std::ptrdiff_t>(dy) - 1) * view.row_stride +
                             (static_cast<std::ptrdiff_t>(dz) - 1) * view.layer_stride;
            rows[dy] = {x_below(b[0], b[-1]), b[0], x_above(b[0], b[1])};
        }
        for (std::size_t dx = 0; dx < 3; ++dx) {
            layers[dz][dx] = y_below(rows[1][dx], rows[0][dx]);
            layers[dz][3 + dx] = rows[1][dx];
            layers[dz][6 + dx] = y_above(rows[1][dx], rows[2][dx]);
        }
    }
    Neighborhoods result;
    for (std::size_t n = 0; n < 9; ++n) {
        result.words[n] = z_below(layers[1][n], layers[0][n]);
        result.words[9 + n] = layers[1][n];
        result.words[18 + n] = z_above(layers[1][n], layers[2][n]);
    }
    return result;
}

Blocks blocks(const BrickView& view, std::ptrdiff_t i) {
    std::array<std::array<Brick, 4>, 2> layers{};
    for (std::size_t dz = 0; dz < 2; ++dz) {
        const Brick* b = view.bricks + i + static_cast<std::ptrdiff_t>(dz) * view.layer_stride;
        const Brick* above = b + view.row_stride;
        const Brick moved = x_above(b[0], b[1]);
        layers[dz] = {b[0], moved, y_above(b[0], above[0]),
                      y_above(moved, x_above(above[0], above[1]))};
    }
    Blocks result;
    for (std::size_t n = 0; n < 4; ++n) {
        result.words[n] = layers[0][n];
        result.words[4 + n] = z_above(layers[0][n], layers[1][n]);
    }
    return result;
}

}  // namespace dem::shapegen
