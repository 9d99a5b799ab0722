// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/outline.hpp"

#include <cmath>

namespace dem::runtime {

/// Directions across a cylinder's axis are unit vectors in the plane, so that nothing here takes a
/// sine of an angle: each evaluation would cost twice as much.
namespace planar {

inline double cross(const Vec2& u, const Vec2& v) {
    return u.x() * v.y() - u.y() * v.x();
}
/// Turned anticlockwise by atan(t).
inline Vec2 turned(const Vec2& u, double t) {
    return Vec2(u.x() - t * u.y(), u.y() + t * u.x()) / std::sqrt(1.0 + t * t);
}
/// The sum of two angles.
inline Vec2 sum(const Vec2& u, const Vec2& v) {
    return {u.x() * v.x() - u.y() * v.y(), u.x() * v.y() + u.y() * v.x()};
}
/// Grows with the angle from `from` to u, from -2 at -180 degrees by way of 0 to 2.
inline double turn_measure(const Vec2& from, const Vec2& u) {
    const double cosine = from.dot(u);
    return cross(from, u) >= 0.0 ? 1.0 - cosine : cosine - 1.0;
}

}  // namespace planar

/// The outline of a body about a cylinder's axis (outline.hpp) and its extrema. Directions are (cos
/// psi, sin psi); (1, 0) is where the body's own axis points.
class PlanarOutline {
  public:
    using Sample = OutlineSampleOf<double>;

    PlanarOutline(const SrSupport& support, const Vec3& cylinder_axis, const Vec3& center,
                  double sense)
        : support_(support), center_(center), sense_(sense) {
        const Vec3 across = support.axis - support.axis.dot(cylinder_axis) * cylinder_axis;
        tilt_ = across.norm();
        if (tilt_ > 1e-9) {
            e1_ = across / tilt_;
            e1_ -= e1_.dot(cylinder_axis) * cylinder_axis;  // what rounding has left of it
        } else {
            const Vec3 other = std::abs(cylinder_axis.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
            e1_ = cylinder_axis.cross(other).normalized();
        }
        e2_ = cylinder_axis.cross(e1_);
    }

    double tilt() const { return tilt_; }  ///< sine of the angle between the axes

    /// Direction of a vector across the axis; (1, 0) for none.
    Vec2 towards(const Vec3& v) const {
        const Vec2 u(v.dot(e1_), v.dot(e2_));
        const double length = u.norm();
        return length > 0.0 ? Vec2(u / length) : Vec2::UnitX();
    }

    Sample at(const Vec2& u) const {
        return outline_sample<double>(support_, center_, u.x() * e1_ + u.y() * e2_,
                                      u.x() * e2_ - u.y() * e1_, sense_);
    }

    /// Local maximum of F between `low` and `high`, less than 180 degrees apart, where F rises at
    /// `low` and falls at `high`: Newton on F' from `start`, kept inside the bracket by bisection.
    Sample maximum(const Vec2& low, const Vec2& high, const Vec2& start) const {
        return extremum(low, high, start, 1.0);
    }
    Sample maximum(const Vec2& low, const Vec2& high) const {
        return maximum(low, high, (low + high).normalized());
    }
    /// Local minimum where F falls at `low` and rises at `high`.
    Sample minimum(const Vec2& low, const Vec2& high) const {
        return extremum(low, high, (low + high).normalized(), -1.0);
    }

    static bool is_between(const Vec2& low, const Vec2& u, const Vec2& high) {
        return planar::cross(low, u) > 0.0 && planar::cross(u, high) > 0.0;
    }

  private:
    /// Maximum of F times `kind`, 1 or -1.
    Sample extremum(Vec2 low, Vec2 high, Vec2 u, double kind) const {
        Sample s = at(u);
        for (int k = 0; k < 100; ++k) {
            const double t = -s.slope / s.curvature;
            const bool is_bent = kind * s.curvature < 0.0;
            if (is_bent && std::abs(t) <= square(step_tolerance)) break;
            (kind * s.slope >= 0.0 ? low : high) = u;
            u = planar::turned(u, t);
            const bool is_newton = is_bent && is_between(low, u, high);
            if (!is_newton) u = (low + high).normalized();
            s = at(u);
            if (is_newton && std::abs(t) <= step_tolerance) break;
        }
        return s;
    }

    static constexpr double step_tolerance = 1e-6;  ///< [rad]; what is left is the square of it

    SrSupport support_;
    Vec3 center_, e1_, e2_;
    double sense_;
    double tilt_ = 0.0;
};

}  // namespace dem::runtime
