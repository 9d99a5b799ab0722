// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/repair/triangle_soup.hpp"

#include <cstdint>

namespace dem::shapegen {

/// As OBJ, PLY and OFF hold a mesh: triangles that share corners.
inline TriangleSoup soup_of(const TriangleMesh& mesh) {
    return {mesh.vertices, mesh.triangles};
}

/// As STL holds a mesh: each triangle with corners of its own.
inline TriangleSoup apart(const TriangleMesh& mesh) {
    TriangleSoup soup;
    for (const auto& triangle : mesh.triangles) {
        const auto n = static_cast<std::uint32_t>(soup.points.size());
        for (const std::uint32_t v : triangle) soup.points.push_back(mesh.vertices[v]);
        soup.triangles.push_back({n, n + 1, n + 2});
    }
    return soup;
}

}  // namespace dem::shapegen
