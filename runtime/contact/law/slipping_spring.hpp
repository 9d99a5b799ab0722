// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/lanes.hpp"

/// Springs with dashpots that slip, and how they are carried along with a contact
/// (docs/contact.md, "Tangential spring", "Slip"): the way all friction is made of.
///   F = -k s - gamma u, |F| at most a limit; s spring, u rate at which it is stretched
namespace dem::runtime {

/// What a contact remembers of a spring.
struct SpringHistory {
    StoredVec3 spring;       ///< half a step ahead [m], in the plane of the contact's last normal
    double stiffness = 0.0;  ///< of the step before [N/m]
};

/// What a spring holds [J], to half a step.
inline double held_energy(const SpringHistory& history) {
    return 0.5 * history.stiffness * Vec3(history.spring).squaredNorm();
}

/// Carries a spring in the plane of `old_normal` into the plane of `normal`: the smallest rotation
/// between the two, then `spin` [rad] about the new one. Both keep its length.
template <class Real>
Vec3Of<Real> carried(const Vec3Of<Real>& spring, const Vec3Of<Real>& old_normal,
                     const Vec3Of<Real>& normal, const Real& spin) {
    const Real cosine = old_normal.dot(normal);
    const Vec3Of<Real> s =
        spring - (old_normal + normal) * Real(normal.dot(spring) / (1.0 + cosine));
    const Real t = 0.5 * spin;  // rotation by 2 atan(t), Cayley
    const Real scale = 1.0 / (1.0 + t * t);
    const Vec3Of<Real> turned =
        Real((1.0 - t * t) * scale) * s + Real(2.0 * t * scale) * normal.cross(s);
    // A normal that turned round within a step is another contact.
    return select(cosine < -0.9, Vec3Of<Real>(Vec3Of<Real>::Zero()), turned);
}

/// Gives a spring its stiffness k of this step, which was `before` in the last, and returns the
/// energy that it loses [J]. `lead`, from the history: the spring half way between the two steps,
/// where the change of stiffness at constant length and that of length at constant stiffness
/// separate. The length stays, so that a spring that stiffens gains; where that were more than
/// `dissipated`, what the contact has taken before [J], the force stays instead, as it does in the
/// theory of elastic contacts under rising load, and the spring becomes shorter.
template <class Real>
Real restiffen(const Real& before, const Real& k, const Real& dissipated, Vec3Of<Real>& lead) {
    const Real size2 = lead.squaredNorm();
    const Real loss = 0.5 * (before - k) * size2;
    const MaskOf<Real> keeps_force = no(-loss <= larger(dissipated, Real{}));
    if (!any(keeps_force)) return loss;
    const Real kept = before / k;
    lead = select(keeps_force, Vec3Of<Real>(lead * kept), lead);
    return select(keeps_force, 0.5 * before * (1.0 - kept) * size2, loss);
}

/// A spring with its dashpot, and the force at which it slips.
template <class Real>
struct SlippingSpringOf {
    Real k;      ///< [N/m]
    Real gamma;  ///< [kg/s]
    Real limit;  ///< [N]
};
using SlippingSpring = SlippingSpringOf<double>;

template <class Real>
struct SpringForceOf {
    Vec3Of<Real> force;  ///< [N]
    Real elastic;        ///< [J]
    Real dissipated;     ///< in this step [J]
};
using SpringForce = SpringForceOf<double>;

/// Spring and dashpot cut at the limit. The force of this step uses the spring at its end,
/// integrated by the trapezoidal rule (second order): `lead`, what the history stores, is ahead of
/// it by u dt/2. When slipping the spring is reset so that the law gives the slip force exactly.
/// Where the dashpot alone exceeds the limit the spring is empty: stretched against the motion, as
/// the rule would have it, it would push forward as soon as the stiffness grows, and with k -> 0
/// at the onset of a Hertzian contact the impact would depend on the time step without limit. The
/// slip force keeps the direction of the force it replaces: along -u in steady slip, along the
/// spring when the limit falls below it while the contact springs back. Slip takes the force of the
/// cut spring, averaged over the step, along the way that was cut off: the spring's own loss of
/// energy counts the whole way at the stretched length and is more by half of k u dt times that
/// way, an error of first order in dt.
template <class Real>
SpringForceOf<Real> slipping_force(const SlippingSpringOf<Real>& s, const Vec3Of<Real>& u,
                                   double dt, Vec3Of<Real>& lead) {
    using Vector = Vec3Of<Real>;
    const Vector half_way = 0.5 * dt * u;
    Vector spring = lead + half_way;
    Vector force = -s.k * spring - s.gamma * u;
    const Real before = 0.5 * s.k * spring.squaredNorm();
    Real elastic = before;
    Real slip{};
    const Real size2 = force.squaredNorm();
    const MaskOf<Real> slips = size2 > s.limit * s.limit;
    if (any(slips)) {
        const Vector cut = force * Real(s.limit / root(size2));
        const Vector spring_force = cut + s.gamma * u;
        const Vector cut_spring = select(spring_force.dot(cut) > 0.0, Vector(spring_force / -s.k),
                                         Vector(Vector::Zero()));
        const Real cut_elastic = 0.5 * s.k * cut_spring.squaredNorm();
        slip = select(
            slips, before - cut_elastic - s.k * half_way.dot(lead + half_way - cut_spring), slip);
        elastic = select(slips, cut_elastic, elastic);
        spring = select(slips, cut_spring, spring);
        force = select(slips, cut, force);
    }
    lead = spring + half_way;
    const Real dashpot = -(force + s.k * spring).dot(u) * dt;
    return {force, elastic, dashpot + slip};
}

}  // namespace dem::runtime
