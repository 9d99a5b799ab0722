// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/import/triangle_soup.hpp"
#include "shapegen/repair/repair_report.hpp"

#include <cstddef>
#include <vector>

/// Faults of a soup that need no topology. Each function changes the soup, reports what it found
/// and keeps the order of what stays.
namespace dem {

/// From corner `side` of a triangle to the next.
struct SoupEdge {
    std::size_t triangle, side;
};

/// The edges that belong to one triangle only, by their ends.
std::vector<SoupEdge> open_edges(const TriangleSoup& soup);

/// Makes corners with equal coordinates one point and drops points that no triangle uses. Not a
/// fault: STL has no other way to write a mesh.
void share_points(TriangleSoup& soup);

/// Removes triangles with two corners in one point.
void remove_collapsed(TriangleSoup& soup, RepairReport& report);

/// Of triangles with the same three corners keeps one of those that face the way most do; none when
/// as many face one way as the other, for they enclose nothing.
void remove_duplicates(TriangleSoup& soup, RepairReport& report);

/// Makes points at open edges that are within `distance` [m] of each other one: cracks that
/// rounding left between faces that belong together.
void close_cracks(TriangleSoup& soup, double distance, RepairReport& report);

}  // namespace dem
