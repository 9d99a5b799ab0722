// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "common/math/types.hpp"
#include "common/shapes/mass_properties.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace dem::shapegen {

/// The surface of a solid: closed, triangles counter-clockwise seen from outside. The functions
/// below rely on it; `shapegen/repair` makes such a mesh from what a file holds.
struct TriangleMesh {
    std::vector<Vec3> vertices;  ///< [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The box around all vertices, empty for a mesh without any.
Aabb bounding_box(const TriangleMesh& mesh);

/// [m^2]
double surface_area(const TriangleMesh& mesh);

/// [m^3]; negative when the mesh is inside out. A hollow inside, its triangles facing into it, is
/// taken off.
double enclosed_volume(const TriangleMesh& mesh);

/// Exact for the polyhedron up to rounding (about 1e-13 relative): the closed form of the
/// tetrahedra that the triangles span with a point near the center.
MassProperties mass_properties(const TriangleMesh& mesh);

/// Area-weighted mean of the squared distance from `center` to the surface [m^2], closed form.
double mean_squared_surface_distance(const TriangleMesh& mesh, const Vec3& center);

}  // namespace dem::shapegen
