// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/support_map.hpp"
#include "runtime/contact/smooth/common_normal.hpp"
#include "runtime/contact/smooth/outline.hpp"

/// A convex surface of revolution that goes on touching the inside of a cylinder at one place: it
/// is found from where it was a step ago with one look at the outline, or two (docs/contact.md,
/// "Walls").
namespace dem::runtime {

/// The inside of a cylinder wall and how a body stands to it.
template <class Real>
struct TubePoseOf {
    Vec3Of<Real> axis;    ///< of the wall, unit
    Vec3Of<Real> center;  ///< of the body relative to the wall's origin [m]
    Real radius;          ///< of the wall [m]
    Real size;            ///< bounding radius of the body [m]
};

/// A direction as seen from a body of revolution, which side of the axis does not matter.
template <class Real>
struct Latitude {
    Real u;    ///< along the axis
    Real n_r;  ///< across it
};
template <class Real>
Latitude<Real> latitude(const Real& u) {
    return {u, root(larger<Real>(Real{}, 1.0 - u * u))};
}

/// Whether nothing of a body is flatter than `radius` [m], along the meridian and across, where its
/// normals lie between two latitudes. Across the meridian the radius of curvature is the mean of
/// those along it from the pole on, so that what it is at the end next to the pole decides. A
/// template for the sake of lanes, which may not share a function (docs/lanes.md).
template <class Real>
bool is_round(const SupportMap& map, double radius, const Latitude<double>& low,
              const Latitude<double>& high) {
    const auto piece_at = [&](const Latitude<double>& at) {
        return support_piece(map, direction_measure(at.n_r, at.u));
    };
    const auto is_round_across = [&](const SupportPiece& p, const Latitude<double>& at) {
        const double a2 = p.a * p.a;
        const double scale = root(a2 * at.n_r * at.n_r + p.b * p.b * at.u * at.u);
        const double r = p.center_r + (scale > 0.0 ? a2 * at.n_r / scale : 0.0);
        return r <= radius * at.n_r;
    };
    const std::uint32_t first = piece_at(low);
    const std::uint32_t last = piece_at(high);
    for (std::uint32_t k = first; k <= last; ++k) {
        const SupportPiece& p = map.pieces[k];
        const double longer = p.a < p.b ? p.b : p.a;
        const double shorter = p.a < p.b ? p.a : p.b;
        if (longer * longer > radius * shorter) return false;
    }
    return !(high.u > 0.0 && !is_round_across(map.pieces[last], high)) &&
           !(low.u < 0.0 && !is_round_across(map.pieces[first], low));
}
template <class Real, class Support>
MaskOf<Real> is_round_between(const Support& support, const Real& radius, const Latitude<Real>& low,
                              const Latitude<Real>& high) {
    if constexpr (OneLane<Real>) {
        return is_round<Real>(support.map, radius, low, high);
    } else {
        MaskOf<Real> mask{};
        for (std::size_t l = 0; l < width_of<Real>; ++l) {
            const Latitude<double> from{low.u[l], low.n_r[l]};
            const Latitude<double> to{high.u[l], high.n_r[l]};
            mask[l] = is_round<Real>(support.map(l), radius[l], from, to) ? -1 : 0;
        }
        return mask;
    }
}

/// Whether a body that touches at e touches nowhere else: two places at the wall would have between
/// them outline flatter than the wall (Blaschke's rolling theorem), and both lie within its
/// bounding sphere. False where that is not certain. `tau`: e turned by 90 degrees about the wall's
/// axis.
template <class Real, class Support>
MaskOf<Real> is_only_place(const Support& support, const TubePoseOf<Real>& pose,
                           const Vec3Of<Real>& e, const Vec3Of<Real>& tau) {
    const MaskOf<Real> is_round = support.bounds().longest_radius <= pose.radius;
    if (all(is_round)) return is_round;
    const MaskOf<Real> is_narrow = 2.0 * pose.size < pose.radius;  // within 90 degrees of e
    // Sines and cosines of the angles from e between which other places may be.
    const Real aside = pose.center.dot(tau);
    const Real one = in_all<Real>(1.0);
    const Real low = clamped<Real>((aside - pose.size) / pose.radius, -one, one);
    const Real high = clamped<Real>((aside + pose.size) / pose.radius, -one, one);
    const Real low_cosine = root(Real(1.0 - square(low)));
    const Real high_cosine = root(Real(1.0 - square(high)));
    // Between which latitudes the outline's normals are there: at the ends, or where they turn.
    const Real u = e.dot(support.axis);
    const Real v = tau.dot(support.axis);
    const Real first = u * low_cosine + v * low;
    const Real last = u * high_cosine + v * high;
    const MaskOf<Real> rises_first = v * low_cosine > u * low;
    const MaskOf<Real> rises_last = v * high_cosine > u * high;
    const Real tilt = smaller<Real>(one, root(Real(u * u + v * v)));
    const Real highest = select(both(rises_first, no(rises_last)), tilt, larger(first, last));
    const Real lowest = select(both(no(rises_first), rises_last), -tilt, smaller(first, last));
    const MaskOf<Real> is_round_near =
        is_round_between<Real>(support, pose.radius, latitude(lowest), latitude(highest));
    return either(is_round, both(is_narrow, is_round_near));
}

/// Where a body touches the inside of a cylinder.
template <class Real>
struct TubePlaceOf {
    CommonNormalOf<Real> at;
    SupportSampleOf<Real> support;  ///< next to it
    Real z;                         ///< along the wall's axis [m]
    MaskOf<Real> is_only;  ///< false: not found, or there may be others; it has to be searched for
};

/// Newton's step along the outline.
template <class Real>
struct OutlineStep {
    OutlineSampleOf<Real> from;
    Vec3Of<Real> tau;
    Real turn;              ///< to the maximum, as the second derivative shows it [rad]
    MaskOf<Real> is_near;   ///< it is a small turn to a maximum
    MaskOf<Real> is_close;  ///< so small that there is no need to look again (is_close())
};

template <class Real, class Support>
OutlineStep<Real> outline_step(const Support& support, const TubePoseOf<Real>& pose,
                               const Vec3Of<Real>& off_axis, const Vec3Of<Real>& e) {
    // What one look may leave [rad].
    constexpr double farthest = 4e-3;
    const Vec3Of<Real> tau = pose.axis.cross(e);
    const OutlineSampleOf<Real> s = outline_sample<Real>(support, off_axis, e, tau);
    const MaskOf<Real> is_bent = s.curvature < 0.0;
    const Real newton = select(is_bent, -s.slope / s.curvature, Real{});
    const MaskOf<Real> is_near = both(is_bent, absolute(newton) < farthest);
    const Real turn = select(is_near, newton, Real{});
    const Real turn2 = turn * turn;
    const Real radius = s.support.across + absolute(s.support.excess);
    const Real scale = NormalSearch::extrapolation * smaller<Real>(pose.size, -s.curvature);
    const MaskOf<Real> is_close = both(is_near, both(4.0 * turn2 < s.support.room * s.support.room,
                                                     turn2 * (radius + pose.size) < scale));
    return {s, tau, turn, is_near, is_close};
}

/// select() of each member.
template <class Mask, class Real>
OutlineStep<Real> chosen(const Mask& m, const OutlineStep<Real>& yes,
                         const OutlineStep<Real>& otherwise) {
    const OutlineSampleOf<Real>& a = yes.from;
    const OutlineSampleOf<Real>& b = otherwise.from;
    return {
        {select(m, a.value, b.value), select(m, a.slope, b.slope),
         select(m, a.curvature, b.curvature), select(m, a.e, b.e), chosen(m, a.support, b.support)},
        select(m, yes.tau, otherwise.tau),
        select(m, yes.turn, otherwise.turn),
        either(both(m, yes.is_near), both(no(m), otherwise.is_near)),
        either(both(m, yes.is_close), both(no(m), otherwise.is_close))};
}

/// The place near where a body touched a step ago, by the normal of then (from the wall).
template <class Real, class Support>
TubePlaceOf<Real> followed_place(const Support& support, const TubePoseOf<Real>& pose,
                                 const Vec3Of<Real>& last_normal) {
    using Vector = Vec3Of<Real>;
    const Vector& axis = pose.axis;
    const Vector off_axis = pose.center - pose.center.dot(axis) * axis;
    const Vector across = last_normal - last_normal.dot(axis) * axis;
    const Real length2 = across.squaredNorm();
    const MaskOf<Real> is_across = length2 > 0.5;
    const Vector start = select(is_across, Vector(-across / root(length2)), last_normal);
    OutlineStep<Real> step = outline_step<Real>(support, pose, off_axis, start);
    if (any(both(no(step.is_close), step.is_near))) {
        const Vector& e = step.from.e;
        const Vector ahead = (e + step.turn * step.tau) / root(Real(1.0 + square(step.turn)));
        step = chosen(step.is_close, step, outline_step<Real>(support, pose, off_axis, ahead));
    }
    const auto& [from, tau, turn, is_near, is_close] = step;
    const Vector e = (from.e + turn * tau) * Real(1.0 - 0.5 * square(turn));
    const Real reach = from.value + 0.5 * from.slope * turn;
    const Vector x = from.support.point(from.e) + from.support.shift(Vector(turn * tau));
    const Real overlap = reach - pose.radius;
    MaskOf<Real> is_only = both(both(is_across, is_close), overlap > 0.0);
    if (any(is_only)) is_only = both(is_only, is_only_place(support, pose, from.e, tau));
    return {
        {e, overlap, x - 0.5 * overlap * e}, from.support, (pose.center + x).dot(axis), is_only};
}

}  // namespace dem::runtime
