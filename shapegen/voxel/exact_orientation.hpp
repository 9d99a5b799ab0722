// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <cmath>

namespace dem::shapegen {

/// The sign of the determinant, whatever the rounding: what the inline functions below ask when
/// doubles cannot tell.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Below, products may have lost bits to underflow, which the bounds of the errors leave out.
inline constexpr double safe_from_underflow = 1e-290;

/// 1 when a, b, c turn counter-clockwise, -1 when clockwise, 0 when they lie on a line. Exact; the
/// bound of the rounding error is that of Shewchuk (1997), "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", as is the next.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right;
    const double bound = 3.4e-16 * (std::abs(left) + std::abs(right)) + safe_from_underflow;
    if (std::abs(determinant) > bound) return determinant > 0.0 ? 1 : -1;
    return exact_orientation(a, b, c);
}

/// 1 when d lies on the side of the plane of a, b, c from which they turn counter-clockwise, -1 on
/// the other, 0 in the plane. Exact.
inline int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = a - d;
    const Vec3 v = b - d;
    const Vec3 w = c - d;
    const double vw = v.x() * w.y();
    const double wv = w.x() * v.y();
    const double wu = w.x() * u.y();
    const double uw = u.x() * w.y();
    const double uv = u.x() * v.y();
    const double vu = v.x() * u.y();
    const double determinant = u.z() * (vw - wv) + v.z() * (wu - uw) + w.z() * (uv - vu);
    const double size = (std::abs(vw) + std::abs(wv)) * std::abs(u.z()) +
                        (std::abs(wu) + std::abs(uw)) * std::abs(v.z()) +
                        (std::abs(uv) + std::abs(vu)) * std::abs(w.z());
    const double bound = 7.8e-16 * size + safe_from_underflow;
    // Positive where d is below the plane, looking down on a counter-clockwise turn.
    if (std::abs(determinant) > bound) return determinant > 0.0 ? -1 : 1;
    return exact_orientation(a, b, c, d);
}

}  // namespace dem::shapegen
