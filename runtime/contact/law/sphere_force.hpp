// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/point_force.hpp"

namespace dem::runtime {

enum class Partner { sphere, wall };

/// Where sphere i touches.
template <class Real>
struct SpherePointOf {
    Vec3Of<Real> normal;  ///< unit, towards i
    Real overlap;         ///< [m]
    Vec3Of<Real> lever;   ///< contact point from the center of i, along the normal [m]
    Real radius;          ///< R* [m]
};

/// Force at a point of a sphere. A lever along the normal has no moment, so the contact's effective
/// mass is the reduced mass in both of ContactLaw::DampingMass, and frictionless spheres get no
/// torque, not even by rounding.
template <Partner partner, class Pair, class Law, class History>
typename Pair::Contact sphere_force(const SpherePointOf<typename Pair::Real>& point,
                                    const Pair& pair, const Law& law, double dt, History& history) {
    using Real = typename Pair::Real;
    PointMotionOf<Pair> motion = motion_at(pair, point.lever, point.normal, point.overlap);
    motion.inverse_mass = inverse_reduced_mass(pair);
    const PointForceOf<Real> f = point_force(motion, point.radius, law, dt, history);
    const Vec3Of<Real> lever_j = point.lever - pair.displacement;

    auto contact =
        point_contact<typename Pair::Contact>(f, point.overlap, point.lever, point.normal);
    contact.force = f.normal * point.normal + f.tangential;
    contact.torque_i += point.lever.cross(f.tangential);
    if constexpr (partner == Partner::sphere) {
        contact.torque_j -= lever_j.cross(f.tangential);
    } else {
        contact.torque_j -= lever_j.cross(contact.force);
    }
    return contact;
}

}  // namespace dem::runtime
