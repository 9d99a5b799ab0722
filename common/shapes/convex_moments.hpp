// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"

namespace dem {

/// Integrals over a solid and over its surface, about the origin of its frame.
struct ConvexMoments {
    double volume = 0.0;                ///< [m^3]
    Vec3 first = Vec3::Zero();          ///< of x over the solid [m^4]
    Mat3 second = Mat3::Zero();         ///< of x x^T over the solid [m^5]
    double area = 0.0;                  ///< [m^2]
    Vec3 surface_first = Vec3::Zero();  ///< of x over the surface [m^3]
    double surface_second = 0.0;        ///< of |x|^2 over the surface [m^4]
};

/// Moments of the rounded body, in closed form (a solid of revolution: Gauss quadrature of
/// polynomials and arcs, to rounding) but for a rounded ellipsoid (adaptive quadrature, 1e-12). A
/// polyhedron is taken apart as Steiner's formula does: core, a slab on every face, a wedge of a
/// cylinder along every edge, a sector of a ball at every vertex.
ConvexMoments convex_moments(const ConvexShape& shape);

}  // namespace dem
