// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/solids/convex_polyhedron.hpp"

#include <cstddef>

namespace dem::shapegen {

/// A convex solid inside another one, the hull of some of its vertices.
struct FewerVertices {
    ConvexPolyhedron solid;
    /// Hausdorff distance of the two, also with an equal rounding around both [m]: how far the
    /// farthest vertex that was left out lies outside.
    double error_max = 0.0;
};

/// The hull of `count` vertices (at least four), each the one that lay farthest outside of the hull
/// of those before it; a solid that has no more stays as it is.
FewerVertices with_fewer_vertices(const ConvexPolyhedron& solid, std::size_t count);

}  // namespace dem::shapegen
