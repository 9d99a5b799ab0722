// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/normal.hpp"
#include "runtime/contact/law/tangential.hpp"
#include "runtime/contact/law/whole_force.hpp"

namespace dem::runtime {

struct PointForce {
    double normal;    ///< > 0 repulsive [N]
    Vec3 tangential;  ///< on i [N]
    Vec3 moment;      ///< on i, beside those of the forces; -moment on j [N m]
    ContactEnergy energy;
};

/// The law of a contact of one point, without the levers of its forces.
inline PointForce point_force(const PointMotion& point, double local_radius, const ContactLaw& law,
                              double dt, PointHistory& history) {
    const PairState& pair = point.pair;
    const Vec3& n = point.normal;
    const Vec3 last_normal = history.normal;
    const bool is_new = !history.touched();
    const double taken = history.dissipated;
    const double radius = effective_radius(law, local_radius, history);
    const ContactCoefficients c = contact_coefficients(
        law, radius, point.overlap, point.inverse_mass, tangential_inertia(pair));

    const NormalForce normal = normal_force(law, c, {point.overlap, point.overlap_rate}, dt);
    const double normal_elastic = elastic_share(law) * normal.elastic_part * point.overlap;
    const double load = friction_load(law, normal.elastic_part, normal.size);
    PointForce f{normal.size, Vec3::Zero(), Vec3::Zero(), {normal_elastic, normal.dissipated}};
    if (law.friction > 0.0) {
        const Sliding sliding{point.velocity, n, last_normal, spin_about(pair, n) * dt, is_new, dt};
        f.tangential = friction_force({c.k_t, c.gamma_t, law.friction * load}, sliding, taken,
                                      history, f.energy);
    }
    f.moment =
        end_step(law, {pair, dt, is_new, n, last_normal, point.lever, c.k_n, load, taken},
                 {local_radius, radius, c.frequency * dt, normal_elastic}, history, f.energy);
    return f;
}

/// The contact that the force of a point at an overlap makes; force and torques are left to where
/// the levers are known.
inline PairContact point_contact(const PointForce& f, double overlap) {
    PairContact contact;
    contact.torque_i = f.moment;
    contact.torque_j = -f.moment;
    contact.overlap = overlap;
    contact.elastic_energy = f.energy.elastic;
    contact.dissipated_energy = f.energy.dissipated;
    contact.points = 1;
    return contact;
}

}  // namespace dem::runtime
