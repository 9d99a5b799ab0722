// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/solids/convex_polyhedron.hpp"

#include <span>

namespace dem::test {

using namespace shapegen;

/// Convex hull of a few points by its definition: a face is all points in a plane that has no point
/// above it. Shares no code with shapegen's hull, needs none of its packages, and takes a time that
/// grows with the third power of the number of points. Points on faces and edges are no use to it.
ConvexPolyhedron hull_by_force(std::span<const Vec3> points);

}  // namespace dem::test
