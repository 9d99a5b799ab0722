// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/convex_hull.hpp"

#include <span>

namespace dem {

/// Convex hull whose triangles are found by exact signs (CGAL), so that points nearly in one plane,
/// as those of files in single precision, cannot mislead it; they are joined to faces as those of
/// convex_hull. Throws Error as that does.
ConvexPolyhedron exact_hull(std::span<const Vec3> points);

}  // namespace dem
