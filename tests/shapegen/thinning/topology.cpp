// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shapegen/thinning/topology.hpp"

#include <cstdlib>

namespace dem::test {

using namespace shapegen;

namespace {

/// Sets of voxels with the wanted value, neighbors being at most `reach` unit steps apart and in
/// the same 3 x 3 x 3 block.
int count_sets(const VoxelImage& image, bool value, int reach) {
    const auto& size = image.grid().size;
    const auto place = [&](const Voxel& v) {
        return static_cast<std::size_t>(v[0] + size[0] * (v[1] + size[1] * v[2]));
    };
    const auto is_in_grid = [&](const Voxel& v) {
        return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < size[0] && v[1] < size[1] &&
               v[2] < size[2];
    };
    std::vector<bool> seen(place({0, 0, size[2]}), false);
    std::vector<Voxel> front;
    const auto reach_voxel = [&](const Voxel& v) {
        if (!is_in_grid(v) || image.contains(v) != value || seen[place(v)]) return false;
        seen[place(v)] = true;
        front.push_back(v);
        return true;
    };
    int sets = 0;
    for (int n = 0; n < size[0] * size[1] * size[2]; ++n) {
        if (!reach_voxel({n % size[0], n / size[0] % size[1], n / (size[0] * size[1])})) continue;
        ++sets;
        while (!front.empty()) {
            const Voxel v = front.back();
            front.pop_back();
            for (int s = 0; s < 27; ++s) {
                const int dx = s % 3 - 1;
                const int dy = s / 3 % 3 - 1;
                const int dz = s / 9 - 1;
                if (std::abs(dx) + std::abs(dy) + std::abs(dz) <= reach)
                    reach_voxel({v[0] + dx, v[1] + dy, v[2] + dz});
            }
        }
    }
    return sets;
}

/// Faces of every dimension lie at the points of a grid of half the spacing: an odd coordinate runs
/// through the inside of a cube, an even one lies between two.
int euler_number(const VoxelImage& image) {
    const auto& size = image.grid().size;
    int euler = 0;
    for (int c = 2; c < 2 * size[2] - 1; ++c) {
        for (int b = 2; b < 2 * size[1] - 1; ++b) {
            for (int a = 2; a < 2 * size[0] - 1; ++a) {
                bool belongs = false;
                for (int k = (c - 1) / 2; k <= c / 2; ++k)
                    for (int j = (b - 1) / 2; j <= b / 2; ++j)
                        for (int i = (a - 1) / 2; i <= a / 2; ++i)
                            belongs = belongs || image.contains({i, j, k});
                if (belongs) euler += (a % 2 + b % 2 + c % 2) % 2 == 0 ? 1 : -1;
            }
        }
    }
    return euler;
}

}  // namespace

Topology topology(const VoxelImage& image) {
    const int components = count_sets(image, true, 3);
    const int cavities = count_sets(image, false, 1) - 1;
    return {components, components + cavities - euler_number(image), cavities};
}

}  // namespace dem::test
