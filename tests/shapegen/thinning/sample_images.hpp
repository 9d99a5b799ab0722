// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/random.hpp"
#include "shapegen/voxel/voxel_image.hpp"

#include <algorithm>

namespace dem::test {

using namespace shapegen;

/// Voxels 0 .. size - 1 along each axis for which belongs(i, j, k) holds, moved in by the border.
template <class Belongs>
VoxelImage image_of(std::array<int, 3> size, Belongs belongs) {
    VoxelImage image({Vec3::Zero(), 1.0, {size[0] + 2, size[1] + 2, size[2] + 2}});
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i)
                if (belongs(i, j, k)) image.insert({i + 1, j + 1, k + 1});
    return image;
}

/// Every voxel with the same probability: all kinds of neighborhoods, thin everywhere.
inline VoxelImage noise(std::array<int, 3> size, double density, std::uint64_t seed) {
    Random random(seed, 0);
    return image_of(size, [&](int, int, int) { return random.uniform() < density; });
}

/// Balls added and taken away in turn: many layers thick, with tunnels and cavities.
inline VoxelImage balls(std::array<int, 3> size, int count, std::uint64_t seed) {
    struct Ball {
        Vec3 center;
        double radius;
    };
    Random random(seed, 1);
    std::vector<Ball> balls;
    const double smallest = *std::min_element(size.begin(), size.end());
    for (int n = 0; n < count; ++n) {
        balls.push_back({{random.uniform(0.0, size[0]), random.uniform(0.0, size[1]),
                          random.uniform(0.0, size[2])},
                         smallest * random.uniform(0.1, n % 2 == 0 ? 0.5 : 0.3)});
    }
    return image_of(size, [&](int i, int j, int k) {
        bool inside = false;
        for (std::size_t n = 0; n < balls.size(); ++n)
            if ((Vec3(i, j, k) - balls[n].center).norm() < balls[n].radius) inside = n % 2 == 0;
        return inside;
    });
}

}  // namespace dem::test
