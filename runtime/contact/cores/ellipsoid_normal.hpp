// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"
#include "common/shapes/sphere.hpp"

namespace dem::runtime {

/// An ellipsoid, or a point, with a sphere around it: h(n) = sqrt(n.M n) + rounding.
struct RoundEllipsoid {
    Mat3 m = Mat3::Zero();  ///< R diag(a^2, b^2, c^2) R^T, world frame [m^2]
    double rounding;        ///< [m]
    double size;            ///< bounding radius [m]

    /// The rounded ellipsoid that a strictly convex shape is.
    RoundEllipsoid(const ConvexShape& shape, const Quat& orientation)
        : rounding(shape.rounding), size(shape.bounding_radius) {
        if (shape.is_polyhedron()) return;
        const Vec3 axes = shape.size;
        const Mat3 r = orientation.toRotationMatrix() * axes.asDiagonal();
        m = r * r.transpose();
    }
    explicit RoundEllipsoid(const Sphere& sphere) : rounding(sphere.radius), size(sphere.radius) {}
};

/// Where two of them share a normal.
struct EllipsoidNormal {
    Vec3 n;          ///< from i to j, unit
    double overlap;  ///< along n [m]; negative: a proven gap
    Vec3 middle;     ///< between the two surface points, from the center of i [m]
};

/// f(n) = h_i(n) + h_j(-n) - n . d for a unit n, d from the center of i to that of j [m].
double overlap_along(const RoundEllipsoid& i, const RoundEllipsoid& j, const Vec3& d,
                     const Vec3& n);

/// The minimum of f by Newton's method on the unit sphere (docs/contact.md, "Common normal"), from
/// `start` downhill. Stops early, at any direction, where the bodies are apart.
EllipsoidNormal common_normal(const RoundEllipsoid& i, const RoundEllipsoid& j, const Vec3& d,
                              const Vec3& start);

}  // namespace dem::runtime
