// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/normal.hpp"
#include "runtime/contact/law/tangential.hpp"
#include "runtime/contact/law/whole_force.hpp"

namespace dem::runtime {

template <class Real>
struct PointForceOf {
    Real normal;              ///< > 0 repulsive [N]
    Vec3Of<Real> tangential;  ///< on i [N]
    Real friction_limit;      ///< [N]
    Vec3Of<Real> moment;      ///< on i, beside those of the forces; -moment on j [N m]
    ContactEnergyOf<Real> energy;
};
using PointForce = PointForceOf<double>;

/// The law of a contact of one point, without the levers of its forces.
template <class Pair, class Law, class History>
PointForceOf<typename Pair::Real> point_force(const PointMotionOf<Pair>& point,
                                              const typename Pair::Real& local_radius,
                                              const Law& law, double dt, History& history) {
    using Real = typename Pair::Real;
    const Pair& pair = point.pair;
    const Vec3Of<Real>& n = point.normal;
    const Vec3Of<Real> last_normal = history.normal;
    const MaskOf<Real> is_new = no(history.touched());
    const Real taken = history.dissipated;
    const Real radius = effective_radius(law, local_radius, history);
    const ContactCoefficientsOf<Real> c = contact_coefficients(
        law, radius, point.overlap, point.inverse_mass, tangential_inertia(pair));

    const NormalForceOf<Real> normal =
        normal_force(law, c, {point.overlap, point.overlap_rate}, dt);
    const Real normal_elastic = elastic_share(law) * normal.elastic_part * point.overlap;
    const Real load = friction_load(law, normal.elastic_part, normal.size);
    PointForceOf<Real> f{normal.size,
                         Vec3Of<Real>::Zero(),
                         law.friction * load,
                         Vec3Of<Real>::Zero(),
                         {normal_elastic, normal.dissipated}};
    if (all(law.friction > 0.0)) {
        const SlidingOf<Real> sliding{point.velocity,           n,      last_normal,
                                      spin_about(pair, n) * dt, is_new, dt};
        f.tangential =
            friction_force({c.k_t, c.gamma_t, f.friction_limit}, sliding, taken, history, f.energy);
    }
    const WholeContactOf<Pair> whole{pair,        dt,    is_new, n,    last_normal,
                                     point.lever, c.k_n, load,   taken};
    f.moment =
        end_step(law, whole, AgeingOf<Real>{local_radius, radius, c.frequency * dt, normal_elastic},
                 history, f.energy);
    return f;
}

/// What the law of one point gives, with its force and the torques of that still to be added.
template <class Contact, class Real>
Contact point_contact(const PointForceOf<Real>& f, const Real& overlap, const Vec3Of<Real>& place,
                      const Vec3Of<Real>& normal) {
    Contact contact;
    contact.torque_i = f.moment;
    contact.torque_j = -f.moment;
    contact.overlap = overlap;
    contact.elastic_energy = f.energy.elastic;
    contact.dissipated_energy = f.energy.dissipated;
    contact.points = 1;
    contact.place = place;
    contact.normal = normal;
    contact.friction = f.tangential;
    contact.friction_limit = f.friction_limit;
    contact.normal_force = f.normal;
    return contact;
}

}  // namespace dem::runtime
