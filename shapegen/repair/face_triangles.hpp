// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"
#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

namespace dem::shapegen {

/// Every face cut into triangles whose corners are its own: faces of four corners along the shorter
/// diagonal that lies inside, larger ones by the Delaunay triangulation of their outline, seen
/// along the axis that they face most. Which corner a file names first, and which way round,
/// changes nothing. Corners may lie on straight edges, outlines may touch themselves and be bridged
/// to their holes. An outline that crosses itself is cut from its first corner, which is reported.
TriangleSoup face_triangles(PolygonSoup faces, RepairReport& report);

}  // namespace dem::shapegen
