// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact_law/contact_mass.hpp"
#include "runtime/contact_law/point_force.hpp"

namespace dem {

enum class Partner { sphere, wall };

/// Force on sphere i at a lever r_i along the normal n. A lever along the normal has no moment, so
/// the contact's effective mass is the reduced mass in both of ContactLaw::DampingMass, and
/// frictionless spheres get no torque, not even by rounding.
template <Partner partner>
PairContact sphere_force(const Vec3& n, double overlap, const Vec3& r_i, double radius,
                         const PairState& pair, const ContactLaw& law, double dt,
                         PointHistory& history) {
    const Vec3 r_j = r_i - pair.displacement;
    PointMotion motion;
    motion.normal = n;
    motion.velocity = pair.i.velocity - pair.j.velocity + pair.i.angular_velocity.cross(r_i) -
                      pair.j.angular_velocity.cross(r_j);
    motion.overlap = overlap;
    motion.overlap_rate = -motion.velocity.dot(n);
    motion.inverse_mass = inverse_reduced_mass(pair);
    motion.spin = 0.5 * n.dot(pair.i.angular_velocity + pair.j.angular_velocity);
    const PointForce f = point_force(motion, radius, law, dt, history);

    PairContact contact;
    contact.force = f.normal * n + f.tangential;
    contact.torque_i = r_i.cross(f.tangential);
    if constexpr (partner == Partner::sphere) {
        contact.torque_j = -r_j.cross(f.tangential);
    } else {
        contact.torque_j = -r_j.cross(contact.force);
    }
    contact.overlap = overlap;
    contact.elastic_energy = f.elastic;
    contact.dissipated_energy = f.dissipated;
    contact.points = 1;
    return contact;
}

}  // namespace dem
