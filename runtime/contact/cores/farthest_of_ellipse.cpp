// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/farthest_of_ellipse.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// The support function from the origin in one quadrant of directions,
///     F(theta) = u sin theta + v cos theta + sqrt(a^2 sin^2 theta + b^2 cos^2 theta),
/// theta angle from the minor axis, u and v coordinates of the center along the major and the minor
/// axis, a maximum of which is a maximum of the distance. theta is held as tan(theta / 2), which
/// spares sines.
class Quadrant {
  public:
    Quadrant(double u, double v, const Ellipse& ellipse)
        : u_(u), v_(v), a2_(square(ellipse.a)), b2_(square(ellipse.b)) {}

    struct Sample {
        double sine, cosine, slope, curvature;
    };
    Sample at(double tangent) const {
        const double scale = 1.0 / (1.0 + tangent * tangent);
        Sample q{};
        q.sine = 2.0 * tangent * scale;
        q.cosine = (1.0 - tangent * tangent) * scale;
        const double s = q.sine;
        const double c = q.cosine;
        const double w = std::sqrt(a2_ * s * s + b2_ * c * c);
        const double rise = w > 0.0 ? (a2_ - b2_) * s * c / w : 0.0;
        q.slope = u_ * c - v_ * s + rise;
        q.curvature = -u_ * s - v_ * c;
        if (w > 0.0) q.curvature += ((a2_ - b2_) * (c * c - s * s) - rise * rise) / w;
        return q;
    }

    /// The maximum of sense * F between `low`, where that rises, and `high`, where it falls: Newton
    /// on the slope, kept inside the bracket by bisection.
    Sample maximum(double low, double high, double sense = 1.0) const {
        double t = 0.5 * (low + high);
        Sample q = at(t);
        for (int k = 0; k < 100 && q.slope != 0.0 && high - low > 1e-15; ++k) {
            (sense * q.slope > 0.0 ? low : high) = t;
            const double step = -q.slope / q.curvature * 0.5 * (1.0 + t * t);
            const bool is_newton = sense * q.curvature < 0.0 && t + step > low && t + step < high;
            t = is_newton ? t + step : 0.5 * (low + high);
            q = at(t);
            // What is left is the square of it.
            if (is_newton && std::abs(step) <= 1e-7) break;
        }
        return q;
    }

  private:
    double u_, v_, a2_, b2_;
};

}  // namespace

Ellipse ellipse_of(const Vec2& center, double m_xx, double m_xy, double m_yy) {
    const double mean = 0.5 * (m_xx + m_yy);
    const double half = 0.5 * (m_xx - m_yy);
    const double radius = std::sqrt(half * half + m_xy * m_xy);
    // Of the two forms of the eigenvector the one that loses no digits.
    Vec2 major = half > 0.0 ? Vec2(half + radius, m_xy) : Vec2(m_xy, radius - half);
    const double length = major.norm();
    major = length > 0.0 ? Vec2(major / length) : Vec2::UnitX();
    return {center, major, std::sqrt(mean + radius), std::sqrt(std::max(0.0, mean - radius))};
}

FarthestPlaces farthest_places(const Ellipse& ellipse) {
    const Vec2& e_u = ellipse.major;
    const Vec2 e_v(-e_u.y(), e_u.x());
    const double u = ellipse.center.dot(e_u);
    const double v = ellipse.center.dot(e_v);
    const double sign_u = u < 0.0 ? -1.0 : 1.0;
    const double sign_v = v < 0.0 ? -1.0 : 1.0;
    FarthestPlaces places;
    const auto direction = [&](const Quadrant::Sample& q, double side) {
        return Vec2(side * sign_u * q.sine * e_u + sign_v * q.cosine * e_v);
    };
    places.direction[places.count++] =
        direction(Quadrant(std::abs(u), std::abs(v), ellipse).maximum(0.0, 1.0), 1.0);

    // The slope of the other quadrant is highest, relative to sin theta cos theta, at theta_0 with
    // tan^3 theta_0 = u b^2 / (v a^2); if it is positive there, a minimum comes before and a
    // maximum follows.
    const Quadrant other(-std::abs(u), std::abs(v), ellipse);
    const double sine = math::cbrt(std::abs(u) * square(ellipse.b));
    const double cosine = math::cbrt(std::abs(v) * square(ellipse.a));
    const double length = std::sqrt(sine * sine + cosine * cosine);
    const double tangent = length > 0.0 ? sine / (length + cosine) : 0.0;
    const double low = std::clamp(tangent, 1e-9, 1.0 - 1e-9);
    if (other.at(low).slope > 0.0) {
        places.direction[places.count++] = direction(other.maximum(low, 1.0), -1.0);
        places.between = direction(other.maximum(0.0, low, -1.0), -1.0);
    }
    return places;
}

}  // namespace dem::runtime
