// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/voxel/voxel_image.hpp"

namespace dem::shapegen {

/// The voxels whose centers lie inside the mesh or on its surface [MS 2.1], without any tolerance:
/// the answer is that of exact arithmetic on the given coordinates. Inside is where the surface
/// winds around the point at least once, so shells that overlap count as one solid and a shell that
/// faces inwards is a cavity. What lies outside the grid or on its border is left out; so are
/// parts of the solid so thin that no center falls into them.
VoxelImage voxelize(const TriangleMesh& mesh, const VoxelGrid& grid);

/// The voxels of the solid inside a mesh on the grid that encloses it, cubes of an edge of
/// `spacing` [m]; throws Error as enclosing_grid does.
VoxelImage voxelize(const TriangleMesh& mesh, double spacing);

}  // namespace dem::shapegen
