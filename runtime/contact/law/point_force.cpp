// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/point_force.hpp"

#include "runtime/contact/law/contact_point.hpp"

namespace dem::runtime {

PairContact contact_force(const ContactPoint& point, double local_radius, const PairState& pair,
                          const ContactLaw& law, double dt, PointHistory& history) {
    const Vec3& g = point.gradient;
    const Vec3 r_i = point.position;
    const Vec3 r_j = point.position - pair.displacement;
    const double slope = g.norm();

    PointMotion motion = motion_at(pair, r_i, g / slope, point.overlap);
    motion.overlap_rate = -motion.velocity.dot(g);
    motion.inverse_mass = law.damping_mass == ContactLaw::DampingMass::contact
                              ? inverse_contact_mass(pair, g, r_i.cross(g), r_j.cross(g))
                              : inverse_reduced_mass(pair);
    // The overlap changes by slope times the way along the normal: f g is the force of a potential.
    const PointForce f = point_force(motion, local_radius, law, dt, history);

    auto contact = point_contact<PairContact>(f, point.overlap, r_i, motion.normal);
    contact.normal_force *= slope;
    contact.force = f.normal * g + f.tangential;
    contact.torque_i += r_i.cross(contact.force);
    contact.torque_j -= r_j.cross(contact.force);
    return contact;
}

}  // namespace dem::runtime
