// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/support_sample.hpp"

#include <cmath>

/// The common normal of two convex bodies: the minimum over unit n of
///     f(n) = h_i(n) + h_j(-n) - n.d
/// d from the centre of i to that of j, h support functions. f(n) is how far the bodies overlap
/// along n: the minimum is the overlap, -f(n) > 0 a proven gap for any n. f is smooth on the pieces
/// of the shapes with kinks between them that crowned faces round off over 4e-4 rad
/// (docs/contact.md, "Common normal"). Newton on the unit sphere; where a step runs across a kink,
/// the line search jumps to where the tangents of both sides meet.
namespace dem {

/// f at a direction with the gradient and all that the second derivative needs.
struct NormalProbe {
    Vec3 n;
    double f;       ///< [m]
    Vec3 gradient;  ///< tangential [m]
    SupportSample i, j;
};

template <class SupportI, class SupportJ>
NormalProbe probe(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                  const Vec3& n) {
    NormalProbe p;
    p.n = n;
    p.i = support_i(n);
    p.j = support_j(-n);
    const double along = n.dot(d);
    p.f = p.i.h + p.j.h - along;
    // The meridian of -n points the same way as that of n, and so does the support point's part.
    p.gradient = p.i.tangential * p.i.meridian - p.j.tangential * p.j.meridian - (d - along * n);
    return p;
}

/// Any unit vector normal to the unit vector n.
inline Vec3 any_tangent(const Vec3& n) {
    const Vec3 other = std::abs(n.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
    return (other - other.dot(n) * n).normalized();
}

/// Newton step in the tangent plane [rad]. The second derivative of f on the sphere is
///     (across_i + across_j - f) 1 + excess_i m_i m_i^T + excess_j m_j m_j^T,
/// lifted to eigenvalues of at least `floor` [m] where f is not convex.
inline Vec3 newton_step(const NormalProbe& p, double floor) {
    Vec3 e1 = p.i.meridian;
    if (p.i.excess == 0.0) e1 = p.j.excess == 0.0 ? any_tangent(p.n) : p.j.meridian;
    const Vec3 e2 = p.n.cross(e1);
    const double a = p.j.meridian.dot(e1);
    const double b = p.j.meridian.dot(e2);
    const double base = p.i.across + p.j.across - p.f;
    double h11 = base + p.i.excess + p.j.excess * a * a;
    double h22 = base + p.j.excess * b * b;
    const double h12 = p.j.excess * a * b;
    const double half_trace = 0.5 * (h11 + h22);
    double determinant = h11 * h22 - h12 * h12;
    if (half_trace < floor || determinant < floor * (2.0 * half_trace - floor)) {
        const double half_gap = std::sqrt(square(0.5 * (h11 - h22)) + h12 * h12);
        const double shift = floor - (half_trace - half_gap);
        h11 += shift;
        h22 += shift;
        determinant = h11 * h22 - h12 * h12;
    }
    const double g1 = p.gradient.dot(e1);
    const double g2 = p.gradient.dot(e2);
    return (-(h22 * g1 - h12 * g2) / determinant) * e1 +
           (-(h11 * g2 - h12 * g1) / determinant) * e2;
}

/// Search parameters; lengths relative to |d|.
struct NormalSearch {
    /// Rounding of f: a support point on a crowned face is the difference of numbers 5000 times the
    /// size of the body. f below it proves a miss, and no search could find an overlap.
    static constexpr double margin = 1e-11;
    static constexpr double step_tolerance = 1e-8;      ///< [rad]; what is left is its square
    static constexpr double gradient_tolerance = 1e-9;  ///< error of the contact point
    static constexpr double floor = 1e-3;               ///< of the second derivative
    static constexpr double longest_step = 0.7;         ///< [rad]
    static constexpr int most_steps = 60;
    static constexpr int most_trials = 40;
};

/// One step from `p` along the tangent `step` that decreases f and at least halves its slope, or
/// stops short of the minimum along the line. Returns p when rounding leaves nothing to gain.
template <class SupportI, class SupportJ>
NormalProbe line_search(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                        const NormalProbe& p, const Vec3& step) {
    // |n + t step| f is convex in t: the tangents at both ends of the bracket meet inside it, and
    // where the minimum is a kink between two smooth pieces they meet close to the kink.
    struct End {
        double t, value, slope;
    };
    const double slope = p.gradient.dot(step);
    const double noise = NormalSearch::margin * d.norm();
    End low{0.0, p.f, slope};
    End high{0.0, 0.0, 0.0};
    // Once a kink is between the ends, one side's slope must not pass for a minimum: the next step
    // would run back across it, and the search to and fro without getting along.
    double flat_enough = -0.5 * slope;
    NormalProbe best = p;  // at the lower end
    double t = 1.0;
    double width = 1.0;
    for (int k = 0; k < NormalSearch::most_trials; ++k) {
        const Vec3 ahead = p.n + t * step;
        const double length = ahead.norm();
        const NormalProbe trial = probe(support_i, support_j, d, Vec3(ahead / length));
        const double trial_slope = trial.gradient.dot(step);
        const bool decreases = trial.f <= p.f + 1e-4 * t * slope + noise;
        if (decreases && (std::abs(trial_slope) <= flat_enough || (k == 0 && trial_slope < 0.0)))
            return trial;
        if (trial_slope > 0.0) flat_enough = std::min(flat_enough, 0.25 * trial_slope);
        const End end{t, length * trial.f, trial_slope + trial.f * trial.n.dot(step)};
        if (decreases && trial_slope < 0.0) {
            low = end;
            best = trial;
        } else {
            high = end;
        }
        const double meeting = (low.value - low.slope * low.t - high.value + high.slope * high.t) /
                               (high.slope - low.slope);
        const bool useful = meeting > low.t && meeting < high.t && high.t - low.t <= 0.5 * width;
        width = high.t - low.t;
        t = useful ? meeting : 0.5 * (low.t + high.t);
    }
    return best;
}

/// Minimises f from the direction `start`. Stops early, at any direction, once f is below
/// -margin |d| and not about to fall much further: the bodies are apart.
template <class SupportI, class SupportJ>
NormalProbe common_normal(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                          const Vec3& start) {
    const double size = d.norm();
    NormalProbe p = probe(support_i, support_j, d, start);
    for (int k = 0; k < NormalSearch::most_steps; ++k) {
        Vec3 step = newton_step(p, NormalSearch::floor * size);
        const double gain = -0.5 * p.gradient.dot(step);
        if (p.f < -NormalSearch::margin * size && gain < -0.25 * p.f) break;
        const double length = step.norm();
        if (length <= NormalSearch::step_tolerance &&
            p.gradient.norm() <= NormalSearch::gradient_tolerance * size)
            break;
        if (length > NormalSearch::longest_step) step *= NormalSearch::longest_step / length;
        const NormalProbe next = line_search(support_i, support_j, d, p, step);
        if (next.f >= p.f && next.gradient.squaredNorm() >= p.gradient.squaredNorm()) break;
        p = next;
    }
    return p;
}

}  // namespace dem
