// SPDX-License-Identifier: GPL-3.0-or-later
// The voxels that thinning looks for by their neighbors alone, 64 at once: bit b of the result is
// voxel b of word i, which must be in a layer that is not border.
#pragma once

#include "shapegen/thinning/word_view.hpp"

namespace dem {

/// Voxels whose six face neighbors belong to X too.
VoxelWord interior_voxels(const WordView& x, std::ptrdiff_t i);

/// Border voxels (not interior) that have no interior face neighbor [MS 2.2].
VoxelWord surface_ends(const WordView& x, const WordView& interior, std::ptrdiff_t i);

/// Voxels with exactly one of 26 neighbors [MS 2.3].
VoxelWord curve_ends(const WordView& x, std::ptrdiff_t i);

}  // namespace dem
