// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/wall_mesh.hpp"

#include <span>
#include <vector>

namespace dem::shapegen {

/// Puts triangles into spatial order and returns the tree of boxes over them (WallMesh::boxes):
/// halves by the middles of the triangles along the longest axis, down to leaves of
/// WallMesh::leaf_size.
std::vector<WallMesh::Box> sort_into_tree(std::span<const Vec3> points,
                                          std::vector<WallMesh::Triangle>& triangles);

}  // namespace dem::shapegen
