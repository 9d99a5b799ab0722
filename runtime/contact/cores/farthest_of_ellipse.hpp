// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <array>
#include <cstddef>

namespace dem::runtime {

/// An ellipse in the plane.
struct Ellipse {
    Vec2 center;  ///< [m]
    Vec2 major;   ///< unit, along the longer axis
    double a, b;  ///< semi-axes [m], a >= b >= 0
};

/// The ellipse of the quadratic form h(e)^2 = e . M e, h its support function from the center.
Ellipse ellipse_of(const Vec2& center, double m_xx, double m_xy, double m_yy);

/// Outward unit normals of an ellipse where its distance from the origin has a maximum.
struct FarthestPlaces {
    std::array<Vec2, 2> direction;
    std::size_t count = 0;
    Vec2 between;  ///< where two are, of the minimum between them
};

/// The places of an ellipse that are farthest from the origin among those beside them: one lies
/// beyond the center on both axes; a second one, across the minor axis, exists where the origin is
/// inside the evolute. Angles are exact to 1e-12.
FarthestPlaces farthest_places(const Ellipse& ellipse);

}  // namespace dem::runtime
