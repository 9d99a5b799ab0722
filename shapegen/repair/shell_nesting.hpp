// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace dem::shapegen {

/// A connected closed surface, one of several.
struct Shell {
    static constexpr std::size_t none = ~std::size_t{0};

    TriangleMesh surface;
    double volume = 0.0;  ///< as the file orients it; negative: inside out [m^3]
    Aabb box;
    std::size_t depth = 0;      ///< number of shells around it
    std::size_t parent = none;  ///< the smallest shell around it

    bool is_turned() const { return volume < 0.0; }
    void turn();
};

struct Shells {
    std::vector<Shell> list;               ///< in falling order of volume
    std::vector<std::size_t> of_triangle;  ///< of each triangle of the mesh
};

/// The connected surfaces of a closed mesh.
Shells split_shells(const TriangleMesh& mesh);

/// Pairs of shells, the one with the lower index first.
using ShellPairs = std::set<std::pair<std::size_t, std::size_t>>;

/// Finds depth and parent of every shell. Of two that do not cross, one point that is not on the
/// other decides; those that cross are not in each other.
void nest(std::vector<Shell>& shells, const ShellPairs& crossing = {});

}  // namespace dem::shapegen
