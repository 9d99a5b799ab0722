// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/support_sample.hpp"

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

/// A convex surface of revolution seen along a cylinder's axis: how far its outline reaches from
/// the axis in each direction e across it,
///     F(psi) = e . (c + x),  F' = tau . (c + x),  F'' = sense rho - F,
/// psi angle of e, c center of the body relative to the axis, x support point towards `sense` e,
/// tau = e', rho radius of curvature of the outline. sense = +1: farthest from the axis; -1:
/// nearest to it. Directions are (cos psi, sin psi); (1, 0) is where the body's own axis points.
class PlanarOutline {
  public:
    struct Sample {
        double value, slope, curvature;
        Vec3 e;
        SupportSample support;  ///< at sense * e
    };

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
        Sample s;
        s.e = u.x() * e1_ + u.y() * e2_;
        const Vec3 tau = u.x() * e2_ - u.y() * e1_;
        s.support = support_(sense_ * s.e);
        const double m = s.support.meridian.dot(tau);
        s.value = center_.dot(s.e) + sense_ * s.support.h;
        s.slope = center_.dot(tau) + s.support.tangential * m;
        const double rho = s.support.across + s.support.excess * m * m;
        s.curvature = sense_ * rho - s.value;
        return s;
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
