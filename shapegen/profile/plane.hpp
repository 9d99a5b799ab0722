// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/types.hpp"

#include <cmath>

namespace dem::shapegen {

/// Third component of the cross product of two vectors of a plane.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// From 0 to pi [rad].
inline double angle_between(const Vec2& a, const Vec2& b) {
    return math::atan2(std::abs(cross(a, b)), a.dot(b));
}

}  // namespace dem::shapegen
