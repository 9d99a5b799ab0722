// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

namespace dem::shapegen {

/// Splits triangles with an open edge at the open points that lie within `distance` [m] of it, so
/// that they fit their neighbors: CAD programs mesh the faces of a solid one by one.
void split_at_t_junctions(TriangleSoup& soup, double distance, RepairReport& report);

}  // namespace dem::shapegen
