// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <algorithm>
#include <cmath>

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
inline Vec3 carried(const Vec3& spring, const Vec3& old_normal, const Vec3& normal, double spin) {
    const double cosine = old_normal.dot(normal);
    // A normal that turned round within a step is another contact.
    if (cosine < -0.9) return Vec3::Zero();
    const Vec3 s = spring - (old_normal + normal) * (normal.dot(spring) / (1.0 + cosine));
    const double t = 0.5 * spin;  // rotation by 2 atan(t), Cayley
    const double scale = 1.0 / (1.0 + t * t);
    return ((1.0 - t * t) * scale) * s + (2.0 * t * scale) * normal.cross(s);
}

/// Gives a spring its stiffness k of this step, which was `before` in the last, and returns the
/// energy that it loses [J]. `lead`, from the history: the spring half way between the two steps,
/// where the change of stiffness at constant length and that of length at constant stiffness
/// separate. The length stays, so that a spring that stiffens gains; where that were more than
/// `dissipated`, what the contact has taken before [J], the force stays instead, as it does in the
/// theory of elastic contacts under rising load, and the spring becomes shorter.
inline double restiffen(double before, double k, double dissipated, Vec3& lead) {
    const double size2 = lead.squaredNorm();
    const double loss = 0.5 * (before - k) * size2;
    if (-loss <= std::max(dissipated, 0.0)) return loss;
    const double kept = before / k;
    lead *= kept;
    return 0.5 * before * (1.0 - kept) * size2;
}

/// A spring with its dashpot, and the force at which it slips.
struct SlippingSpring {
    double k;      ///< [N/m]
    double gamma;  ///< [kg/s]
    double limit;  ///< [N]
};

struct SpringForce {
    Vec3 force;         ///< [N]
    double elastic;     ///< [J]
    double dissipated;  ///< in this step [J]
};

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
inline SpringForce slipping_force(const SlippingSpring& s, const Vec3& u, double dt, Vec3& lead) {
    const Vec3 half_way = 0.5 * dt * u;
    Vec3 spring = lead + half_way;
    Vec3 force = -s.k * spring - s.gamma * u;
    const double before = 0.5 * s.k * spring.squaredNorm();
    double elastic = before;
    double slip = 0.0;
    const double size2 = force.squaredNorm();
    if (size2 > s.limit * s.limit) {
        force *= s.limit / std::sqrt(size2);
        const Vec3 spring_force = force + s.gamma * u;
        spring = spring_force.dot(force) > 0.0 ? Vec3(spring_force / -s.k) : Vec3::Zero();
        elastic = 0.5 * s.k * spring.squaredNorm();
        slip = before - elastic - s.k * half_way.dot(lead + half_way - spring);
    }
    lead = spring + half_way;
    const double dashpot = -(force + s.k * spring).dot(u) * dt;
    return {force, elastic, dashpot + slip};
}

}  // namespace dem::runtime
