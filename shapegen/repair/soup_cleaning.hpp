// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/edge_sides.hpp"
#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

#include <vector>

/// Faults of a soup that need no topology. Each function changes the soup, reports what it found
/// and keeps the order of what stays.
namespace dem::shapegen {

/// The edges that belong to one triangle only, by their ends.
std::vector<EdgeSide> open_edges(const TriangleSoup& soup);

/// Removes the other triangles.
void keep_triangles(TriangleSoup& soup, const std::vector<bool>& is_kept);

/// Makes corners with equal coordinates one point and drops points that no triangle uses. Not a
/// fault: STL has no other way to write a mesh.
void share_points(TriangleSoup& soup);

/// Removes triangles with two corners in one point.
void remove_collapsed(TriangleSoup& soup, RepairReport& report);

/// Makes points at open edges that are within `distance` [m] of each other one: cracks that
/// rounding left between faces that belong together.
void close_cracks(TriangleSoup& soup, double distance, RepairReport& report);

}  // namespace dem::shapegen
