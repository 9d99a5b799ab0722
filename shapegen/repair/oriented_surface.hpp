// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/surface_mesh.hpp"
#include "shapegen/repair/triangle_soup.hpp"

namespace dem::shapegen {

/// The triangles of a clean soup (shapegen/repair/soup_cleaning) joined along their edges and
/// turned to agree with their neighbors, the way most of a connected piece faces. Edges of more
/// than two triangles and points where separate fans meet are split, pieces that fit joined again.
SurfaceMesh oriented_surface(const TriangleSoup& soup, RepairReport& report);

}  // namespace dem::shapegen
