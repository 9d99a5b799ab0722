// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

namespace dem::shapegen {

/// What thinning keeps beside the topology.
enum class Skeleton {
    surface,   ///< surface ends: the medial surface, from which candidate spheres come
    curve,     ///< curve ends: the medial axis, free of the spurious sheets of rough surfaces
    ultimate,  ///< nothing: one voxel is left of a solid without tunnels and cavities
};

/// The skeleton of a set of voxels by [MS Algorithm 1], asymmetric and parallel: each pass takes a
/// whole layer of voxels away. It has exactly as many components (26-connected), tunnels and
/// cavities as the image. Of the voxels that may go but not together, the first in the order of the
/// grid stays, so the skeleton is the same for any number of threads.
VoxelImage thin(const VoxelImage& image, Skeleton kind);

}  // namespace dem::shapegen
