// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

namespace dem::shapegen {

/// True when the solid inside a closed, outward, connected mesh is convex: then no triangle rises
/// above the plane of a neighbor by more than a millionth of the body's size, which is what the
/// single precision of mesh files leaves of flat faces.
bool is_convex(const TriangleMesh& mesh);

}  // namespace dem::shapegen
