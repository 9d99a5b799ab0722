// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_curves.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

/// Point and derivatives of (r, z) = (x(s), y(s)), s = start + t * range, from those by s.
CurveJet by_parameter(const CurveJet& jet, double range) {
    return {jet.point, range * jet.first, range * range * jet.second};
}

/// (r, z) = g (a cos s, c sin s), g = (|cos s|^m + |sin s|^m)^(-1/m): regular everywhere, unlike
/// the usual powers of cos and sin, which stand still at the axes.
class SuperquadricQuarter final : public ParametricCurve {
  public:
    SuperquadricQuarter(double a, double c, double m, bool upper)
        : a_(a), c_(c), m_(m), start_(upper ? 0.0 : -0.5 * pi) {}

    CurveJet evaluate(double t) const override {
        const double s = start_ + 0.5 * pi * t;
        const double x = std::max(math::cos(s), 0.0);
        const double y = math::sin(s);
        const double h = std::abs(y);
        const double sign = y < 0.0 ? -1.0 : 1.0;
        // Below m = 2 the curvature is infinite at the axes; keep it finite there.
        const double x2 = math::pow(std::max(x, 1e-9), m_ - 2.0);
        const double h2 = math::pow(std::max(h, 1e-9), m_ - 2.0);
        const double sum = x * x * x2 + h * h * h2;
        const double sum1 = m_ * sign * x * h * (h2 - x2);
        const double sum2 = m_ * ((m_ - 1.0) * (x2 * h * h + h2 * x * x) - sum);
        const double g = math::pow(sum, -1.0 / m_);
        const double log1 = -sum1 / (m_ * sum);  // derivatives of ln g
        const double log2 = -(sum2 / sum - square(sum1 / sum)) / m_;
        const double g1 = g * log1;
        const double g2 = g * (log2 + log1 * log1);
        return by_parameter(
            {{a_ * g * x, c_ * g * y},
             {a_ * (g1 * x - g * y), c_ * (g1 * y + g * x)},
             {a_ * (g2 * x - 2.0 * g1 * y - g * x), c_ * (g2 * y + 2.0 * g1 * x - g * y)}},
            0.5 * pi);
    }

  private:
    double a_, c_, m_, start_;
};

/// (r, z) = rho (sin s, cos s), rho^2 = f^2 cos 2s + sqrt(p^4 - f^4 sin^2 2s), s from pi to 0.
class CassiniHalf final : public ParametricCurve {
  public:
    CassiniHalf(double focus, double product_root)
        : f2_(focus * focus), p4_(square(product_root * product_root)) {}

    CurveJet evaluate(double t) const override {
        const double s = pi * (1.0 - t);
        const double f4 = f2_ * f2_;
        const double c2 = math::cos(2.0 * s);
        const double s2 = math::sin(2.0 * s);
        const double root = std::sqrt(p4_ - f4 * s2 * s2);
        const double root1 = -2.0 * f4 * s2 * c2 / root;
        const double root2 = (-4.0 * f4 * (c2 * c2 - s2 * s2) - root1 * root1) / root;
        const double rho = std::sqrt(f2_ * c2 + root);
        const double rho1 = (-2.0 * f2_ * s2 + root1) / (2.0 * rho);
        const double rho2 = (-4.0 * f2_ * c2 + root2 - 2.0 * rho1 * rho1) / (2.0 * rho);
        const double x = t == 0.0 || t == 1.0 ? 0.0 : math::sin(s);
        const double y = math::cos(s);
        return by_parameter(
            {{rho * x, rho * y},
             {rho1 * x + rho * y, rho1 * y - rho * x},
             {rho2 * x + 2.0 * rho1 * y - rho * x, rho2 * y - 2.0 * rho1 * x - rho * y}},
            -pi);
    }

  private:
    double f2_, p4_;
};

/// (r, z) = (R cos s, sin s (c0 + c1 cos^2 s + c2 cos^4 s) / 2), s from -pi/2 to pi/2.
class RedBloodCellHalf final : public ParametricCurve {
  public:
    RedBloodCellHalf(double radius, const std::array<double, 3>& c) : radius_(radius), c_(c) {}

    CurveJet evaluate(double t) const override {
        const double s = pi * (t - 0.5);
        const double x = t == 0.0 || t == 1.0 ? 0.0 : math::cos(s);
        const double y = math::sin(s);
        const double thickness = c_[0] + x * x * (c_[1] + x * x * c_[2]);
        const double slope = x * (2.0 * c_[1] + 4.0 * x * x * c_[2]);  // d thickness / d x
        const double bend = 2.0 * c_[1] + 12.0 * x * x * c_[2];
        const double thickness1 = -y * slope;
        const double thickness2 = -x * slope + y * y * bend;
        return by_parameter(
            {{radius_ * x, 0.5 * y * thickness},
             {-radius_ * y, 0.5 * (x * thickness + y * thickness1)},
             {-radius_ * x, 0.5 * (-y * thickness + 2.0 * x * thickness1 + y * thickness2)}},
            pi);
    }

  private:
    double radius_;
    std::array<double, 3> c_;
};

class CubicBezier final : public ParametricCurve {
  public:
    explicit CubicBezier(const std::array<Vec2, 4>& p) : p_(p) {}

    CurveJet evaluate(double t) const override {
        const double u = 1.0 - t;
        const Vec2 d0 = p_[1] - p_[0];
        const Vec2 d1 = p_[2] - p_[1];
        const Vec2 d2 = p_[3] - p_[2];
        // From the nearer end, so that both ends are met to the last bit.
        const Vec2 point =
            t < 0.5
                ? Vec2(p_[0] + t * (3.0 * d0 + t * (3.0 * (d1 - d0) + t * (d2 - 2.0 * d1 + d0))))
                : Vec2(p_[3] - u * (3.0 * d2 - u * (3.0 * (d2 - d1) - u * (d2 - 2.0 * d1 + d0))));
        return {point, 3.0 * (u * u * d0 + 2.0 * u * t * d1 + t * t * d2),
                6.0 * (u * (d1 - d0) + t * (d2 - d1))};
    }

  private:
    std::array<Vec2, 4> p_;
};

}  // namespace

std::array<ProfileSegment, 2> superquadric_quarters(double a, double c, double m) {
    return {FreeCurve{std::make_shared<SuperquadricQuarter>(a, c, m, false)},
            FreeCurve{std::make_shared<SuperquadricQuarter>(a, c, m, true)}};
}

ProfileSegment cassini_half(double focus, double product_root) {
    return FreeCurve{std::make_shared<CassiniHalf>(focus, product_root)};
}

ProfileSegment red_blood_cell_half(double diameter, const std::array<double, 3>& c) {
    return FreeCurve{std::make_shared<RedBloodCellHalf>(0.5 * diameter, c)};
}

ProfileSegment cubic_bezier(const std::array<Vec2, 4>& control_points) {
    return FreeCurve{std::make_shared<CubicBezier>(control_points)};
}

}  // namespace dem::shapegen
