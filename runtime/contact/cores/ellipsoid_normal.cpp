// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/ellipsoid_normal.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// One side: radius of the core along n, its support point and second derivative.
struct CoreSupport {
    double s = 0.0;
    Vec3 x = Vec3::Zero();
    Mat3 second = Mat3::Zero();

    CoreSupport(const RoundEllipsoid& e, const Vec3& n, bool with_second) {
        const Vec3 mn = e.m * n;
        const double s2 = n.dot(mn);
        if (s2 == 0.0) return;  // a point
        s = std::sqrt(s2);
        x = mn / s;
        if (with_second) second = (e.m - x * x.transpose()) / s;
    }
};

struct Tangents {
    Vec3 e1, e2;
    explicit Tangents(const Vec3& n) {
        const Vec3 other = std::abs(n.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
        e1 = (other - other.dot(n) * n).normalized();
        e2 = n.cross(e1);
    }
};

constexpr double step_tolerance = 1e-10;  ///< [rad]
constexpr double longest_step = 0.5;      ///< [rad]
constexpr int most_steps = 60;

/// Newton's step in the tangent plane, the second derivative lifted to `floor` where f is not
/// convex.
Vec3 newton_step(const CoreSupport& i, const CoreSupport& j, const Vec3& d, const Vec3& n,
                 double floor) {
    const Tangents t(n);
    const Vec3 gradient = i.x + j.x - d;
    const Mat3 second = i.second + j.second;
    const double radial = n.dot(gradient);
    double h11 = t.e1.dot(second * t.e1) - radial;
    double h22 = t.e2.dot(second * t.e2) - radial;
    const double h12 = t.e1.dot(second * t.e2);
    const double lowest = 0.5 * (h11 + h22) - std::sqrt(square(0.5 * (h11 - h22)) + h12 * h12);
    const double lift = std::max(0.0, floor - lowest);
    h11 += lift;
    h22 += lift;
    const double g1 = t.e1.dot(gradient);
    const double g2 = t.e2.dot(gradient);
    const double scale = -1.0 / (h11 * h22 - h12 * h12);
    Vec3 step = scale * ((h22 * g1 - h12 * g2) * t.e1 + (h11 * g2 - h12 * g1) * t.e2);
    const double length = step.norm();
    if (length > longest_step) step *= longest_step / length;
    return step;
}

}  // namespace

double overlap_along(const RoundEllipsoid& i, const RoundEllipsoid& j, const Vec3& d,
                     const Vec3& n) {
    return CoreSupport(i, n, false).s + CoreSupport(j, n, false).s + i.rounding + j.rounding -
           n.dot(d);
}

EllipsoidNormal common_normal(const RoundEllipsoid& i, const RoundEllipsoid& j, const Vec3& d,
                              const Vec3& start) {
    const double size = i.size + j.size;
    const double noise = 1e-15 * size;
    Vec3 n = start.normalized();
    double f = overlap_along(i, j, d, n);
    for (int k = 0; k < most_steps; ++k) {
        const CoreSupport side_i(i, n, true);
        const CoreSupport side_j(j, n, true);
        const Vec3 step = newton_step(side_i, side_j, d, n, 1e-3 * size);
        const double slope = (side_i.x + side_j.x - d).dot(step);
        if (f < 0.0 && slope > 0.5 * f) break;
        if (step.squaredNorm() <= square(step_tolerance)) break;
        double t = 1.0;
        Vec3 ahead = (n + step).normalized();
        double f_ahead = overlap_along(i, j, d, ahead);
        while (!(f_ahead <= f + 1e-4 * t * slope + noise)) {
            t *= 0.5;
            if (t <= 1e-6) break;
            ahead = (n + t * step).normalized();
            f_ahead = overlap_along(i, j, d, ahead);
        }
        if (f_ahead > f + noise) break;
        n = ahead;
        f = f_ahead;
    }
    const Vec3 x_i = CoreSupport(i, n, false).x + i.rounding * n;
    const Vec3 x_j = d - CoreSupport(j, n, false).x - j.rounding * n;
    return {n, f, 0.5 * (x_i + x_j)};
}

}  // namespace dem::runtime
