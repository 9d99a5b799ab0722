// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/support_sample.hpp"

#include <cmath>

/// The common normal of two convex bodies: the minimum over unit n of
///     f(n) = h_i(n) + h_j(-n) - n.d
/// d from the center of i to that of j, h support functions. f(n) is how far the bodies overlap
/// along n: the minimum is the overlap, -f(n) > 0 a proven gap for any n. f is smooth on the pieces
/// of the shapes with kinks between them that crowned faces round off over 4e-4 rad
/// (docs/contact.md, "Common normal"). Newton on the unit sphere; where a step runs across a kink,
/// the line search jumps to where the tangents of both sides meet.
namespace dem::runtime {

/// f at a direction with the gradient and all that the second derivative needs.
template <class Real>
struct NormalProbeOf {
    Vec3Of<Real> n;
    Real f;                 ///< [m]
    Vec3Of<Real> gradient;  ///< tangential [m]
    SupportSampleOf<Real> i, j;
};
using NormalProbe = NormalProbeOf<double>;

template <class Real = double, class SupportI, class SupportJ>
NormalProbeOf<Real> probe(const SupportI& support_i, const SupportJ& support_j,
                          const Vec3Of<Real>& d, const Vec3Of<Real>& n) {
    NormalProbeOf<Real> p;
    p.n = n;
    p.i = support_i(n);
    p.j = support_j(-n);
    const Real along = n.dot(d);
    p.f = p.i.h + p.j.h - along;
    // The meridian of -n points the same way as that of n, and so does the support point's part.
    p.gradient = p.i.tangential * p.i.meridian - p.j.tangential * p.j.meridian - (d - along * n);
    return p;
}

/// Any unit vector normal to the unit vector n.
template <class Real = double>
Vec3Of<Real> any_tangent(const Vec3Of<Real>& n) {
    using Vector = Vec3Of<Real>;
    const Vector other =
        select(absolute(n.x()) < 0.7, Vector(Vector::UnitX()), Vector(Vector::UnitY()));
    const Vector tangent = other - other.dot(n) * n;
    return tangent / tangent.norm();
}

/// A unit vector that was carried from step to step, as long as it should be. Its length drifts by
/// rounding, and a step of the search makes an error of it larger: flats have support points from
/// centers thousands of times the size away.
template <class Real = double>
Vec3Of<Real> unit_again(const Vec3Of<Real>& n) {
    return n * Real(1.5 - 0.5 * n.squaredNorm());
}

template <class Real>
struct NewtonStepOf {
    Vec3Of<Real> turn;    ///< in the tangent plane [rad]
    MaskOf<Real> lifted;  ///< f is not convex enough here, the step is shorter than Newton's
};
using NewtonStep = NewtonStepOf<double>;

/// Newton step to the minimum of f. The second derivative of f on the sphere is
///     (across_i + across_j - f) 1 + excess_i m_i m_i^T + excess_j m_j m_j^T,
/// lifted to eigenvalues of at least `floor` [m] where f is not convex.
template <class Real>
NewtonStepOf<Real> newton_step(const NormalProbeOf<Real>& p, const Real& floor) {
    using Vector = Vec3Of<Real>;
    Vector e1 = select(p.i.excess == 0.0, p.j.meridian, p.i.meridian);
    const MaskOf<Real> has_none = both(p.i.excess == 0.0, p.j.excess == 0.0);
    if (any(has_none)) e1 = select(has_none, any_tangent<Real>(p.n), e1);
    const Vector e2 = p.n.cross(e1);
    const Real a = p.j.meridian.dot(e1);
    const Real b = p.j.meridian.dot(e2);
    const Real base = p.i.across + p.j.across - p.f;
    Real h11 = base + p.i.excess + p.j.excess * a * a;
    Real h22 = base + p.j.excess * b * b;
    const Real h12 = p.j.excess * a * b;
    const Real half_trace = 0.5 * (h11 + h22);
    Real determinant = h11 * h22 - h12 * h12;
    const MaskOf<Real> lifted =
        either(half_trace < floor, determinant < floor * (2.0 * half_trace - floor));
    if (any(lifted)) {
        const Real half_gap = root(square(Real(0.5 * (h11 - h22))) + h12 * h12);
        const Real shift = select(lifted, floor - (half_trace - half_gap), Real{});
        h11 += shift;
        h22 += shift;
        determinant = select(lifted, h11 * h22 - h12 * h12, determinant);
    }
    const Real g1 = p.gradient.dot(e1);
    const Real g2 = p.gradient.dot(e2);
    const Real scale = -1.0 / determinant;
    return {Real(scale * (h22 * g1 - h12 * g2)) * e1 + Real(scale * (h11 * g2 - h12 * g1)) * e2,
            lifted};
}

/// Search parameters; lengths relative to |d|.
struct NormalSearch {
    /// Rounding of f: a support point on a crowned face is the difference of numbers 5000 times the
    /// size of the body. f below it proves a miss, and no search could find an overlap.
    static constexpr double margin = 1e-11;
    static constexpr double step_tolerance = 1e-8;      ///< [rad]; what is left is its square
    static constexpr double gradient_tolerance = 1e-9;  ///< error of the contact point
    static constexpr double extrapolation = 1e-10;
    static constexpr double floor = 1e-3;        ///< of the second derivative
    static constexpr double longest_step = 0.7;  ///< [rad]
    static constexpr int most_steps = 60;
    static constexpr int most_trials = 40;
};

/// One step from `p` along the tangent `step` that decreases f and at least halves its slope, or
/// stops short of the minimum along the line. Returns p when rounding leaves nothing to gain.
template <class SupportI, class SupportJ>
NormalProbe line_search(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                        const NormalProbe& p, const Vec3& step, double size) {
    // |n + t step| f is convex in t: the tangents at both ends of the bracket meet inside it, and
    // where the minimum is a kink between two smooth pieces they meet close to the kink.
    struct End {
        double t, value, slope;
    };
    const double slope = p.gradient.dot(step);
    const double step2 = step.squaredNorm();
    const double noise = NormalSearch::margin * size;
    End low{0.0, p.f, slope};
    End high{0.0, 0.0, 0.0};
    // Once a kink is between the ends, one side's slope must not pass for a minimum: the next step
    // would run back across it, and the search to and fro without getting along.
    double flat_enough = -0.5 * slope;
    NormalProbe best = p;  // at the lower end
    double t = 1.0;
    double width = 1.0;
    for (int k = 0; k < NormalSearch::most_trials; ++k) {
        const double length = std::sqrt(1.0 + t * t * step2);
        const Vec3 ahead = (p.n + t * step) / length;
        NormalProbe trial = probe(support_i, support_j, d, ahead);
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

/// Minimizes f from a probe. Stops early, at any direction, once f is below -margin |d| and not
/// about to fall much further: the bodies are apart.
template <class SupportI, class SupportJ>
NormalProbe descend(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                    NormalProbe p) {
    const double size = d.norm();
    for (int k = 0; k < NormalSearch::most_steps; ++k) {
        Vec3 turn = newton_step(p, NormalSearch::floor * size).turn;
        const double gain = -0.5 * p.gradient.dot(turn);
        if (p.f < -NormalSearch::margin * size && gain < -0.25 * p.f) break;
        const double length = turn.norm();
        if (length <= NormalSearch::step_tolerance &&
            p.gradient.norm() <= NormalSearch::gradient_tolerance * size)
            break;
        if (length > NormalSearch::longest_step) turn *= NormalSearch::longest_step / length;
        const NormalProbe next = line_search(support_i, support_j, d, p, turn, size);
        if (next.f >= p.f && next.gradient.squaredNorm() >= p.gradient.squaredNorm()) break;
        p = next;
    }
    return p;
}

template <class SupportI, class SupportJ>
NormalProbe common_normal(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                          const Vec3& start) {
    return descend(support_i, support_j, d, probe(support_i, support_j, d, start));
}

/// Where two bodies share a normal.
template <class Real>
struct CommonNormalOf {
    Vec3Of<Real> n;       ///< from i to j, unit
    Real f;               ///< [m]
    Vec3Of<Real> middle;  ///< between the two surface points, from the center of i [m]
};
using CommonNormal = CommonNormalOf<double>;

template <class Real>
CommonNormalOf<Real> result_of(const NormalProbeOf<Real>& p, const Vec3Of<Real>& d) {
    return {p.n, p.f, 0.5 * (p.i.point(p.n) + p.j.point(-p.n) + d)};
}

/// The minimum as the second derivative at a nearby direction shows it, without evaluating f there.
/// What is left out is of the order of the turn squared.
template <class Real>
CommonNormalOf<Real> extrapolated(const NormalProbeOf<Real>& p, const Vec3Of<Real>& turn,
                                  const Vec3Of<Real>& d) {
    CommonNormalOf<Real> c = result_of(p, d);
    c.n = (p.n + turn) * Real(1.0 - 0.5 * turn.squaredNorm());
    c.f += 0.5 * p.gradient.dot(turn);
    c.middle += 0.5 * (p.i.shift(turn) - p.j.shift(turn));
    return c;
}

/// Whether a turn is small enough for that: nowhere near a jump of the curvature, and what is left
/// out of the contact point below `extrapolation` |d|.
template <class Real>
MaskOf<Real> is_close(const NormalProbeOf<Real>& p, const NewtonStepOf<Real>& step,
                      const Real& size) {
    const Real turn2 = step.turn.squaredNorm();
    const Real room = smaller(p.i.room, p.j.room);
    const Real radius = p.i.across + p.j.across + absolute(p.i.excess) + absolute(p.j.excess);
    return both(no(step.lifted),
                both(4.0 * turn2 < room * room,
                     turn2 * (radius + size) < NormalSearch::extrapolation * size));
}

/// A minimum and where f was last evaluated: there, or where it was extrapolated from.
struct FollowedNormal {
    CommonNormal at;
    NormalProbe probe;
};

/// Newton's step from a direction.
template <class Real>
struct NormalStepOf {
    NormalProbeOf<Real> from;
    NewtonStepOf<Real> step;
    MaskOf<Real> is_close;  ///< is_close()
};

template <class Real = double, class SupportI, class SupportJ>
NormalStepOf<Real> normal_step(const SupportI& support_i, const SupportJ& support_j,
                               const Vec3Of<Real>& d, const Real& size, const Vec3Of<Real>& n) {
    const NormalProbeOf<Real> p = probe<Real>(support_i, support_j, d, n);
    const NewtonStepOf<Real> step = newton_step(p, Real(NormalSearch::floor * size));
    return {p, step, is_close(p, step, size)};
}

/// select() of each member.
template <class Mask, class Real>
NormalStepOf<Real> chosen(const Mask& m, const NormalStepOf<Real>& yes,
                          const NormalStepOf<Real>& otherwise) {
    const NormalProbeOf<Real>& a = yes.from;
    const NormalProbeOf<Real>& b = otherwise.from;
    return {{select(m, a.n, b.n), select(m, a.f, b.f), select(m, a.gradient, b.gradient),
             chosen(m, a.i, b.i), chosen(m, a.j, b.j)},
            {select(m, yes.step.turn, otherwise.step.turn),
             either(both(m, yes.step.lifted), both(no(m), otherwise.step.lifted))},
            either(both(m, yes.is_close), both(no(m), otherwise.is_close))};
}

/// From a direction that was the minimum a moment ago: Newton's step from there, or, where that is
/// too long to be taken without another look, from where it leads. Where it is close then
/// extrapolated() gives the minimum; where not it has to be searched for.
template <class Real = double, class SupportI, class SupportJ>
NormalStepOf<Real> followed_step(const SupportI& support_i, const SupportJ& support_j,
                                 const Vec3Of<Real>& d, const Real& size,
                                 const Vec3Of<Real>& start) {
    // After a longer one the next is not close either [rad].
    constexpr double longest = 4e-3;
    const NormalStepOf<Real> first =
        normal_step<Real>(support_i, support_j, d, size, unit_again<Real>(start));
    const Vec3Of<Real>& turn = first.step.turn;
    const Real turn2 = turn.squaredNorm();
    const MaskOf<Real> is_near = both(no(first.step.lifted), turn2 < longest * longest);
    if (!any(both(no(first.is_close), is_near))) return first;
    const Vec3Of<Real> ahead = select(
        is_near, Vec3Of<Real>((first.from.n + turn) / root(Real(1.0 + turn2))), first.from.n);
    const NormalStepOf<Real> second = normal_step<Real>(support_i, support_j, d, size, ahead);
    if constexpr (OneLane<Real>) return second;
    return chosen(first.is_close, first, second);
}

/// What common_normal() finds from a direction that was the minimum a moment ago.
template <class SupportI, class SupportJ>
FollowedNormal followed_normal(const SupportI& support_i, const SupportJ& support_j, const Vec3& d,
                               const Vec3& start) {
    const NormalStepOf<double> s = followed_step(support_i, support_j, d, d.norm(), start);
    if (s.is_close) return {extrapolated(s.from, s.step.turn, d), s.from};
    const NormalProbe p = descend(support_i, support_j, d, s.from);
    return {result_of(p, d), p};
}

}  // namespace dem::runtime
