// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/common_normal.hpp"

/// A convex surface of revolution at a plane, and how its place runs there (docs/contact.md,
/// "Walls").
namespace dem::runtime {

/// Where a body touches a plane.
template <class Real>
struct PlanePlaceOf {
    CommonNormalOf<Real> at;
    SupportSampleOf<Real> support;  ///< against the plane's normal
};

/// `n`: out of the plane; `height`: of the body's center above it [m].
template <class Real, class Support>
PlanePlaceOf<Real> place_at_plane(const Support& support, const Vec3Of<Real>& n,
                                  const Real& height) {
    const SupportSampleOf<Real> s = support(-n);
    const Real overlap = s.h - height;
    return {{-n, overlap, s.point(-n) + 0.5 * overlap * n}, s};
}

/// How a plane turns in a step, seen from a body.
template <class Real>
struct PlaneSwing {
    Vec3Of<Real> half;  ///< of the change of its normal
    Real angle;         ///< [rad]
};

/// `axis`: of the body, about which it turns without a change; `spin`: of the body relative to the
/// plane in a step [rad].
template <class Real>
PlaneSwing<Real> plane_swing(const Vec3Of<Real>& axis, const Vec3Of<Real>& n,
                             const Vec3Of<Real>& spin) {
    const Vec3Of<Real> turn = spin - spin.dot(axis) * axis;
    const Vec3Of<Real> half = 0.5 * turn.cross(n);
    return {half, 2.0 * half.norm()};
}

/// The part of a swing by which a place runs along a straight line of the wall, `line` its unit
/// direction: along its axis a cylinder is as a plane.
template <class Real>
PlaneSwing<Real> along_line(const PlaneSwing<Real>& swing, const Vec3Of<Real>& line) {
    const Vec3Of<Real> half = swing.half.dot(line) * line;
    return {half, 2.0 * half.norm()};
}

/// Farther than this share of the size of a body its place at a plane does not run in a step
/// without being looked at closer (docs/contact.md, "Creases").
inline constexpr double longest_run = 0.05;

/// Whether a place certainly runs no farther in a step. `size`: bounding radius [m].
template <class Real>
MaskOf<Real> stays_near(const SupportSampleOf<Real>& now, const PlaneSwing<Real>& swing,
                        const Real& size) {
    return both(now.room > swing.angle, now.along() * swing.angle < longest_run * size);
}

}  // namespace dem::runtime
