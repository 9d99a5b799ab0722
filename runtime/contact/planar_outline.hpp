// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/support_sample.hpp"

#include <cmath>

namespace dem {

/// A convex surface of revolution seen along a cylinder's axis: how far its outline reaches from
/// the axis in each direction e(psi) across it,
///     F(psi) = e . (c + x),  F' = tau . (c + x),  F'' = sense rho - F,
/// c centre of the body relative to the axis, x support point towards `sense` e, tau = e', rho
/// radius of curvature of the outline. sense = +1: farthest from the axis; -1: nearest to it. psi =
/// 0 is where the body's own axis points.
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
        } else {
            const Vec3 other = std::abs(cylinder_axis.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
            e1_ = cylinder_axis.cross(other).normalized();
        }
        e2_ = cylinder_axis.cross(e1_);
    }

    double tilt() const { return tilt_; }  ///< sine of the angle between the axes
    double angle_of(const Vec3& v) const { return std::atan2(v.dot(e2_), v.dot(e1_)); }

    Sample at(double psi) const {
        const double cosine = std::cos(psi);
        const double sine = std::sin(psi);
        Sample s;
        s.e = cosine * e1_ + sine * e2_;
        const Vec3 tau = cosine * e2_ - sine * e1_;
        s.support = support_(sense_ * s.e);
        const double m = s.support.meridian.dot(tau);
        s.value = center_.dot(s.e) + sense_ * s.support.h;
        s.slope = center_.dot(tau) + s.support.tangential * m;
        const double rho = s.support.across + s.support.excess * m * m;
        s.curvature = sense_ * rho - s.value;
        return s;
    }

    /// Local maximum of F in [low, high], where F rises at `low` and falls at `high`: Newton on F',
    /// kept inside the bracket by bisection.
    Sample maximum(double low, double high) const {
        double psi = 0.5 * (low + high);
        Sample s = at(psi);
        for (int k = 0; k < 100; ++k) {
            (s.slope >= 0.0 ? low : high) = psi;
            double next = psi - s.slope / s.curvature;
            if (!(s.curvature < 0.0) || !(next > low && next < high)) next = 0.5 * (low + high);
            const double step = std::abs(next - psi);
            psi = next;
            s = at(psi);
            if (step <= 1e-9) break;  // what is left is the square of it
        }
        return s;
    }

  private:
    SrSupport support_;
    Vec3 center_, e1_, e2_;
    double sense_;
    double tilt_ = 0.0;
};

}  // namespace dem
