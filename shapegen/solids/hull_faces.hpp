// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/solids/convex_polyhedron.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace dem::shapegen {

/// Throws Error for fewer than four points and numbers that are not finite.
void require_points_of_hull(std::span<const Vec3> points);

/// Throws Error: so many points lie in one plane.
[[noreturn]] void fail_flat_hull(std::size_t points);

/// The solid inside triangles of a closed convex surface, whose corners are numbers of points.
/// Triangles that lie within 1e-9 of the extent of one plane become one face (down to 1e-11 where
/// such faces would have holes), unless it would not be convex; one that is lower than this has no
/// plane of its own and belongs to the face along its longest edge. Throws Error where faces cannot
/// be told apart.
ConvexPolyhedron polyhedron_of(std::span<const Vec3> points,
                               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace dem::shapegen
