// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/support_sample.hpp"

namespace dem::runtime {

/// A convex surface of revolution seen along a cylinder's axis: how far its outline reaches from
/// the axis in a direction e across it,
///     F(psi) = e . (c + x),  F' = tau . (c + x),  F'' = sense rho - F,
/// psi angle of e, c center of the body relative to the axis, x support point towards `sense` e,
/// tau = e', rho radius of curvature of the outline. sense = +1: farthest from the axis; -1:
/// nearest to it.
template <class Real>
struct OutlineSampleOf {
    Real value;  ///< F [m]
    Real slope, curvature;
    Vec3Of<Real> e;
    SupportSampleOf<Real> support;  ///< at sense * e
};

/// `tau`: unit, e turned by 90 degrees about the axis.
template <class Real, class Support>
OutlineSampleOf<Real> outline_sample(const Support& support, const Vec3Of<Real>& center,
                                     const Vec3Of<Real>& e, const Vec3Of<Real>& tau,
                                     double sense = 1.0) {
    OutlineSampleOf<Real> s;
    s.e = e;
    s.support = support(Vec3Of<Real>(sense * e));
    const Real m = s.support.meridian.dot(tau);
    s.value = center.dot(e) + sense * s.support.h;
    s.slope = center.dot(tau) + s.support.tangential * m;
    const Real rho = s.support.across + s.support.excess * m * m;
    s.curvature = sense * rho - s.value;
    return s;
}

}  // namespace dem::runtime
