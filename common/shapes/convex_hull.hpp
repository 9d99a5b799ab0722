// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// A convex solid with flat faces. Every vertex has at least three faces, no two faces lie in one
/// plane, every edge is shared by two faces.
struct ConvexPolyhedron {
    std::vector<Vec3> vertices;                     ///< [m]
    std::vector<std::vector<std::uint32_t>> faces;  ///< counter-clockwise seen from outside

    /// Unit outward normal of a face.
    Vec3 normal(std::size_t face) const;
    /// Largest n . x of a face's vertices [m]; they differ by rounding.
    double offset(std::size_t face, const Vec3& n) const;
};

/// Convex hull (quickhull, Barber et al. 1996). Points nearer to it than 1e-11 of the extent are
/// taken for points on it, faces whose vertices lie within 1e-9 of the extent of one plane for one
/// face. Throws Error for fewer than four points, numbers that are not finite and points that lie
/// in one plane.
ConvexPolyhedron convex_hull(std::span<const Vec3> points);

/// All points of the solid at least `depth` [m] below its surface: the planes of the faces moved
/// inwards. Throws Error when nothing is left around its center.
ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth);

}  // namespace dem
