// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/surface_mesh.hpp"

#include <vector>

namespace dem {

/// Pairs of triangles that cross or overlap, in the order of their faces. Triangles that only share
/// a corner or an edge do not count, also where the surface was split there. Exact.
Finding self_intersections(const SurfaceMesh& mesh);

/// Cuts out the surroundings of crossing triangles and closes the gaps anew, where there are no
/// more than one for fifty triangles; reports what that changed. Returns what still crosses.
std::vector<Finding> remove_self_intersections(SurfaceMesh& mesh, RepairReport& report);

}  // namespace dem
