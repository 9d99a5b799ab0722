// SPDX-License-Identifier: GPL-3.0-or-later
// [MS Algorithm 1] word for word, one voxel at a time and without any of the shortcuts of
// shapegen/thinning: what the fast version has to agree with.
#pragma once

#include "shapegen/thinning/thin.hpp"

#include <cstdint>

namespace dem::test {

using namespace shapegen;

/// The 26 neighbors of a voxel, bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1) each; bit 13 is zero.
using Neighbors = std::uint32_t;

/// [MS Theorem 1], its two conditions by flooding.
bool is_simple(Neighbors neighbors);
bool is_simple(const VoxelImage& X, const Voxel& v);

/// Whether a set of voxels inside a 3 x 3 x 3 block, bits as in Neighbors, can be reduced to one
/// voxel by taking away one simple voxel after another.
bool is_reducible(std::uint32_t set);

/// The critical cliques of a rank by the definition alone.
std::vector<std::vector<Voxel>> critical_cliques(const VoxelImage& X, int rank);

VoxelImage reference_skeleton(const VoxelImage& image, Skeleton kind);

}  // namespace dem::test
