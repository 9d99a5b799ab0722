// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/surface_mesh.hpp"

#include <utility>
#include <vector>

namespace dem::shapegen {

/// Two triangles that cross or overlap, the one of the lower index first.
using CrossingPair = std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>;

/// The pairs of triangles that cross or overlap, in rising order. Triangles that only share a
/// corner or an edge do not count, also where the surface was split there. Exact. A surface that
/// crosses itself everywhere has more pairs than memory holds: the search ends at 20 times as many
/// as triangles.
std::vector<CrossingPair> crossing_pairs(const SurfaceMesh& mesh);

/// Crossing triangles of one part of a surface, and of two closed parts.
struct SelfIntersections {
    std::vector<CrossingPair> pairs;
    Finding within, between;

    /// Those of the two that there are.
    std::vector<Finding> findings() const;
};

SelfIntersections self_intersections(SurfaceMesh& mesh);

/// Cuts out the surroundings of crossing triangles and closes the gaps anew, where there are no
/// more than one pair for fifty triangles, none of two closed parts; reports what that changed.
/// Returns what still crosses.
std::vector<Finding> remove_self_intersections(SurfaceMesh& mesh, RepairReport& report);

}  // namespace dem::shapegen
