// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/surface_mesh.hpp"

#include <vector>

namespace dem::shapegen {

/// Closes the holes of a surface and removes open scraps. What lay in a hole is unknown: half a
/// ball on it is taken as what the patch may have got wrong, 2/3 A sqrt(A/pi) for a hole of area A.
/// An open piece with no more at stake than `limit` (a fraction of the volume of all pieces) is
/// removed instead of closed. Where holes put more than that at stake they stay open and are
/// returned, as are those that no patch fits; also when the surface encloses no volume at all.
std::vector<Finding> close_holes(SurfaceMesh& mesh, double limit, RepairReport& report);

/// Removes triangles without area. Returns what stayed.
std::vector<Finding> remove_flat_triangles(SurfaceMesh& mesh, RepairReport& report);

}  // namespace dem::shapegen
