// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/surface_mesh.hpp"

#include <vector>

namespace dem::shapegen {

/// Closed parts that cross, share faces or hold each other become their union (corefinement, worked
/// out exactly, corners rounded to double precision at the end). A part may have hollows, which
/// face into themselves; a shell that faces like the one around it is a part that the other holds.
/// Reports how many parts became one and the volume that they shared. Returns what has no union:
/// parts that cross themselves, or that meet in an edge or a corner alone.
std::vector<Finding> unite_parts(SurfaceMesh& mesh, RepairReport& report);

}  // namespace dem::shapegen
