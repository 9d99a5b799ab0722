// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/triangle_soup.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem::shapegen {

/// A side of a triangle: from one corner to the next.
struct EdgeSide {
    std::uint32_t low, high;  ///< the ends of its edge
    std::uint32_t corner;     ///< 3 x triangle + the corner that it begins at

    std::size_t triangle() const { return corner / 3; }
    std::size_t side() const { return corner % 3; }
    bool has_edge_of(const EdgeSide& other) const { return low == other.low && high == other.high; }
};

/// All sides by their edges, those of one edge in the order of the triangles.
std::vector<EdgeSide> sides_by_edge(const TriangleSoup& soup);

/// Calls `visit(begin, end)` with the sides of each edge.
template <class Visit>
void visit_edges(const std::vector<EdgeSide>& sides, const Visit& visit) {
    for (auto begin = sides.begin(); begin != sides.end();) {
        auto end = begin;
        while (end != sides.end() && end->has_edge_of(*begin)) ++end;
        visit(begin, end);
        begin = end;
    }
}

}  // namespace dem::shapegen
