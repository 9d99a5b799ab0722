// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/solids/convex_polyhedron.hpp"

#include <span>

namespace dem::shapegen {

/// Convex hull whose triangles are found by exact signs (CGAL), so that points nearly in one plane,
/// as those of files in single precision, cannot mislead it. Faces whose vertices lie within 1e-9
/// of the extent of one plane are taken for one face. Throws Error for fewer than four points,
/// numbers that are not finite and points that lie in one plane.
ConvexPolyhedron exact_hull(std::span<const Vec3> points);

}  // namespace dem::shapegen
