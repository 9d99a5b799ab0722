// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/skeletal_voxels.hpp"

namespace dem {

namespace {

constexpr std::array<Step, 6> face_steps{unit_steps[0],  unit_steps[1],  unit_steps[2],
                                         -unit_steps[0], -unit_steps[1], -unit_steps[2]};

}  // namespace

VoxelWord interior_voxels(const WordView& x, std::ptrdiff_t i) {
    VoxelWord inside = x[i];
    if (inside == 0) return 0;
    for (const Step& step : face_steps) inside &= x.at(i, step);
    return inside;
}

VoxelWord surface_ends(const WordView& x, const WordView& interior, std::ptrdiff_t i) {
    VoxelWord ends = x[i] & ~interior[i];
    for (const Step& step : face_steps) ends &= ~interior.at(i, step);
    return ends;
}

VoxelWord curve_ends(const WordView& x, std::ptrdiff_t i) {
    VoxelWord one = 0;
    VoxelWord more = 0;
    const auto add = [&](VoxelWord neighbors) {
        more |= one & neighbors;
        one |= neighbors;
    };
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0 || dz != 0) add(x.at(i, {dx, dy, dz}));
        }
    }
    return x[i] & one & ~more;
}

}  // namespace dem
