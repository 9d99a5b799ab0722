// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dem::shapegen {

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

/// What makes the convex hull of points.
using HullOfPoints = std::function<ConvexPolyhedron(std::span<const Vec3>)>;

/// All points of the solid at least `depth` [m] below its surface: the planes of the faces moved
/// inwards, which meet where `hull` finds it. Throws Error when nothing is left around its center.
ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth, const HullOfPoints& hull);

}  // namespace dem::shapegen
