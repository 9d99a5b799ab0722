// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/common_normal.hpp"

#include <optional>

/// Other minima of f (common_normal.hpp) beside a known one. The overlap of two bodies is the least
/// of them. Bodies with edges that overlap have several where edges lie along each other: the edge
/// may be left over either of the faces that meet in it. As the bodies move another one becomes
/// the least, and the one that was it may vanish while f there is far from the least: whoever
/// followed one minimum would lose energy (docs/contact.md, "Several minima").
namespace dem::runtime {

/// Radius of a ball that fits into a body and touches its surface at a support point, and at those
/// half of the room away: a lower bound [m].
template <class Bounds, class Real>
Real ball_within(const Bounds& bounds, const SupportSampleOf<Real>& s) {
    const Real room = 0.5 * smaller(s.room, in_all<Real>(1.0));
    return larger<Real>(bounds.shortest_radius, bounds.ball_slope * s.along() * room);
}

/// Distance of a support point from the axis of its body [m].
template <class Real>
Real radius_of(const SupportSampleOf<Real>& s, const Vec3Of<Real>& n, const Vec3Of<Real>& axis) {
    return s.point(n).cross(axis).norm();
}

/// Whether the cross-sections of both bodies at their support points prove that no other minimum is
/// as low as the one at p. `distance`: |d|; `inner`: the sum of both bodies' inner radii [m].
template <class Real, class SupportI, class SupportJ>
MaskOf<Real> is_least_by_crossing(const NormalProbeOf<Real>& p, const SupportI& i,
                                  const SupportJ& j, const Vec3Of<Real>& d) {
    const Real one = in_all<Real>(1.0);
    const Real distance = d.norm();
    const Real inner = i.bounds().inner_radius + j.bounds().inner_radius;
    // Minima as low as p.f lie within an angle from d whose cosine is `nearest`; p.n itself does.
    const Real nearest = (inner - p.f) / distance;
    const Real here = smaller<Real>(one, p.n.dot(d) / distance);
    const Real farthest =
        here * nearest - root(larger<Real>(Real{}, (1.0 - square(here)) * (1.0 - square(nearest))));
    const Real r_i = radius_of<Real>(p.i, p.n, i.axis);
    const Real r_j = radius_of<Real>(p.j, -p.n, j.axis);
    const Real sine2 = 1.0 - square(Real(p.i.meridian.dot(p.j.meridian)));
    const Real sum = r_i + r_j;
    const Real least =
        0.5 * (sum - root(larger<Real>(Real{}, square(sum) - 4.0 * r_i * r_j * sine2)));
    const MaskOf<Real> no_room = nearest >= 1.0;
    const MaskOf<Real> some_room = nearest > -1.0;
    return either(no_room, both(some_room, least * (1.0 + farthest) >= 2.0 * p.f));
}

/// Whether no other minimum of f is as low as the one at p, or at a place so near that none of the
/// pieces ends half way to it. False where that is not certain.
template <class Real, class SupportI, class SupportJ>
MaskOf<Real> is_least(const NormalProbeOf<Real>& p, const SupportI& i, const SupportJ& j,
                      const Vec3Of<Real>& d) {
    const MaskOf<Real> within = ball_within(i.bounds(), p.i) + ball_within(j.bounds(), p.j) >= p.f;
    if (all(within)) return within;
    return either(within, is_least_by_crossing(p, i, j, d));
}

/// The lowest other minimum, if there is one no higher than `highest` [m].
std::optional<NormalProbe> rival_normal(const NormalProbe& p, const SrSupport& i,
                                        const SrSupport& j, const Vec3& d, double highest);

}  // namespace dem::runtime
