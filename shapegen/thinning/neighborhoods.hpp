// SPDX-License-Identifier: GPL-3.0-or-later
// The neighbors of the 64 voxels of a brick: bit by bit, word n holds the voxels one step away, so
// what is computed from such words by logical operations is computed for 64 voxels at once.
#pragma once

#include "shapegen/thinning/brick_image.hpp"

#include <array>

namespace dem::shapegen {

/// A step from a voxel to one of its neighbors, each part -1, 0 or 1.
struct Step {
    int x = 0, y = 0, z = 0;

    constexpr Step operator+(const Step& b) const { return {x + b.x, y + b.y, z + b.z}; }
    constexpr Step operator-() const { return {-x, -y, -z}; }
};

inline constexpr std::array<Step, 3> unit_steps{Step{1, 0, 0}, Step{0, 1, 0}, Step{0, 0, 1}};

/// The bricks of an image with their neighbors.
struct BrickView {
    const Brick* bricks;
    std::ptrdiff_t row_stride, layer_stride;

    explicit BrickView(const BrickImage& image)
        : bricks(image.bricks()),
          row_stride(image.row_stride()),
          layer_stride(image.layer_stride()) {}

    Brick operator[](std::ptrdiff_t i) const { return bricks[i]; }
};

/// Voxels of a brick with x = 0, x = 3, y = 0, y = 3.
inline constexpr Brick first_x = 0x1111111111111111;
inline constexpr Brick last_x = 0x8888888888888888;
inline constexpr Brick first_y = 0x000f000f000f000f;
inline constexpr Brick last_y = 0xf000f000f000f000;

/// The voxels one step up or down an axis from those of a brick, given it and its neighbor there.
inline Brick x_above(Brick b, Brick next) {
    return ((b & ~first_x) >> 1) | ((next & first_x) << 3);
}
inline Brick x_below(Brick b, Brick previous) {
    return ((b & ~last_x) << 1) | ((previous & last_x) >> 3);
}
inline Brick y_above(Brick b, Brick next) {
    return ((b & ~first_y) >> 4) | ((next & first_y) << 12);
}
inline Brick y_below(Brick b, Brick previous) {
    return ((b & ~last_y) << 4) | ((previous & last_y) >> 12);
}
inline Brick z_above(Brick b, Brick next) {
    return (b >> 16) | (next << 48);
}
inline Brick z_below(Brick b, Brick previous) {
    return (b << 16) | (previous >> 48);
}

/// All 3 x 3 x 3 steps.
struct Neighborhoods {
    std::array<Brick, 27> words{};

    static constexpr std::size_t place(Step s) {
        const int n = (s.x + 1) + 3 * (s.y + 1) + 9 * (s.z + 1);
        return static_cast<std::size_t>(n);
    }
    constexpr Brick& operator[](Step s) { return words[place(s)]; }
    constexpr Brick operator[](Step s) const { return words[place(s)]; }
};

/// The steps with no part of -1: the voxels of the 2 x 2 x 2 block that begins at each voxel.
struct Blocks {
    std::array<Brick, 8> words{};

    static constexpr std::size_t place(Step s) {
        const int n = s.x + 2 * s.y + 4 * s.z;
        return static_cast<std::size_t>(n);
    }
    constexpr Brick& operator[](Step s) { return words[place(s)]; }
    constexpr Brick operator[](Step s) const { return words[place(s)]; }
};

Neighborhoods neighborhoods(const BrickView& view, std::ptrdiff_t i);
Blocks blocks(const BrickView& view, std::ptrdiff_t i);

}  // namespace dem::shapegen
