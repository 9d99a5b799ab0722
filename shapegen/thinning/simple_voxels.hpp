// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

#include <array>

namespace dem {

/// The neighborhoods of 64 voxels at once: word (dx + 1) + 3 (dy + 1) + 9 (dz + 1) holds, bit by
/// bit, the neighbors at (dx, dy, dz); word 13, the voxels themselves, is not looked at.
using Neighborhoods = std::array<VoxelWord, 27>;

/// Which of the 64 voxels are simple: taking one away changes neither the number of components nor
/// that of cavities or tunnels [MS Theorem 1].
VoxelWord simple_voxels(const Neighborhoods& neighbors);

}  // namespace dem
