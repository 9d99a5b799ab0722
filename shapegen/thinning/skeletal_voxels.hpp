// SPDX-License-Identifier: GPL-3.0-or-later
// The voxels of brick i that thinning tells apart by their neighbors alone.
#pragma once

#include "shapegen/thinning/neighborhoods.hpp"

namespace dem::shapegen {

/// Voxels whose six face neighbors belong to X too.
Brick interior_voxels(const BrickView& x, std::ptrdiff_t i);

/// Border voxels (not interior) that have no interior face neighbor [MS 2.2].
Brick surface_ends(const BrickView& x, const BrickView& interior, std::ptrdiff_t i);

/// Voxels with exactly one of 26 neighbors [MS 2.3].
Brick curve_ends(const BrickView& x, std::ptrdiff_t i);

}  // namespace dem::shapegen
