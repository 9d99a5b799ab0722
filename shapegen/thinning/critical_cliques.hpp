// SPDX-License-Identifier: GPL-3.0-or-later
// A clique of rank i is the set of all voxels of an image X around one face of dimension i of the
// grid (a voxel itself, a square, an edge, a corner), provided that nothing larger than that face
// is common to them. It is critical when the voxels that touch all of it cannot be shrunk to a
// point: then one of its voxels must stay for the topology to stay [MS 2.1, Theorem 2].
//
// Each function tests 64 faces at once. Bit b of the result stands for the clique whose block of
// voxels (1 x 1 x 2, 1 x 2 x 2, 2 x 2 x 2) begins, at its lowest coordinates, at voxel b of word i;
// word i must be in a layer that is not border. Left out are cliques with a voxel in `kept`: their
// voxel that stays is chosen already.
#pragma once

#include "shapegen/thinning/word_view.hpp"

namespace dem {

/// Critical cliques of rank 3: voxels of X outside `kept` that are not simple.
VoxelWord critical_3_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i);

/// Critical cliques of rank 2: two voxels one step along the axis apart.
template <int Axis>
VoxelWord critical_2_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i);

/// Critical cliques of rank 1: two to four voxels around an edge along the axis.
template <int Axis>
VoxelWord critical_1_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i);

/// Cliques of rank 0, two to eight voxels around a corner; no voxel touches all of one, so all are
/// critical.
VoxelWord critical_0_cliques(const WordView& x, const WordView& kept, std::ptrdiff_t i);

}  // namespace dem
