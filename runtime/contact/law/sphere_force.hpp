// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/point_force.hpp"

namespace dem::runtime {

enum class Partner { sphere, wall };

/// Where sphere i touches.
struct SpherePoint {
    Vec3 normal;     ///< unit, towards i
    double overlap;  ///< [m]
    Vec3 lever;      ///< contact point from the center of i, along the normal [m]
    double radius;   ///< R* [m]
};

/// Force at a point of a sphere. A lever along the normal has no moment, so the contact's effective
/// mass is the reduced mass in both of ContactLaw::DampingMass, and frictionless spheres get no
/// torque, not even by rounding.
template <Partner partner>
PairContact sphere_force(const SpherePoint& point, const PairState& pair, const ContactLaw& law,
                         double dt, PointHistory& history) {
    PointMotion motion = motion_at(pair, point.lever, point.normal, point.overlap);
    motion.inverse_mass = inverse_reduced_mass(pair);
    const PointForce f = point_force(motion, point.radius, law, dt, history);
    const Vec3 lever_j = point.lever - pair.displacement;

    PairContact contact = point_contact(f, point.overlap);
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
