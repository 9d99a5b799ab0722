// SPDX-License-Identifier: GPL-3.0-or-later
// A clique of rank i is the set of all voxels of an image X around one face of dimension i of the
// grid (a voxel itself, a square, an edge, a corner), provided that nothing larger than that face
// is common to them. It is critical when the voxels that touch all of it cannot be shrunk to a
// point: then one of its voxels must stay for the topology to stay [MS 2.1, Theorem 2]. Of rank 3
// are the voxels that are not simple.
//
// Each function looks at the cliques whose block of voxels (1 x 1 x 2, 1 x 2 x 2, 2 x 2 x 2)
// begins, at its lowest coordinates, at one of 64 voxels, and marks that voxel. Left out are
// cliques with a voxel that is not `removable`: the voxel of theirs that stays is chosen already.
#pragma once

#include "shapegen/thinning/neighborhoods.hpp"

namespace dem::shapegen {

/// Critical cliques of rank 2: two voxels one step along the axis apart.
template <int Axis>
Brick critical_2_cliques(const Neighborhoods& x, const Blocks& removable);

/// Critical cliques of rank 1: two to four voxels around an edge along the axis.
template <int Axis>
Brick critical_1_cliques(const Neighborhoods& x, const Blocks& removable);

/// Cliques of rank 0, two to eight voxels around a corner; no voxel touches all of one, so all are
/// critical.
Brick critical_0_cliques(const Blocks& x, const Blocks& removable);

}  // namespace dem::shapegen
