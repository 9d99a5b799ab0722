// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

namespace dem {

/// A step from a voxel to one of its neighbors, each part -1, 0 or 1.
struct Step {
    int x = 0, y = 0, z = 0;

    constexpr Step operator+(const Step& b) const { return {x + b.x, y + b.y, z + b.z}; }
    constexpr Step operator-() const { return {-x, -y, -z}; }
};

inline constexpr std::array<Step, 3> unit_steps{Step{1, 0, 0}, Step{0, 1, 0}, Step{0, 0, 1}};

/// The words of an image with their neighbors.
struct WordView {
    const VoxelWord* words;
    std::ptrdiff_t row_stride, layer_stride;

    explicit WordView(const VoxelImage& image)
        : words(image.words()),
          row_stride(image.row_stride()),
          layer_stride(image.layer_stride()) {}

    VoxelWord operator[](std::ptrdiff_t i) const { return words[i]; }

    /// Bit b is the voxel one step away from voxel b of word i, which is in a layer that is not
    /// border.
    VoxelWord at(std::ptrdiff_t i, Step step) const {
        const VoxelWord* w = words + i + step.y * row_stride + step.z * layer_stride;
        if (step.x > 0) return (w[0] >> 1) | (w[1] << 63);
        if (step.x < 0) return (w[0] << 1) | (w[-1] >> 63);
        return w[0];
    }
};

}  // namespace dem
