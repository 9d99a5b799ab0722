// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/law/point_force.hpp"
#include "runtime/contact/smooth/common_normal.hpp"

namespace dem::runtime {

/// R* where two convex bodies touch (docs/contact.md, "Effective radius") [m]. `d_eq`: diameters of
/// the spheres of equal volume.
template <class Law, class Real>
Real contact_radius(const Law& law, const SupportSampleOf<Real>& i, const Real& d_eq_i,
                    const SupportSampleOf<Real>& j, const Real& d_eq_j) {
    if (law.geometry.radius == ContactLaw::Radius::equivalent)
        return 0.5 * d_eq_i * d_eq_j / (d_eq_i + d_eq_j);
    const Real r_i = mean_curvature_radius(i, d_eq_i);
    const Real r_j = mean_curvature_radius(j, d_eq_j);
    return r_i * r_j / (r_i + r_j);
}

/// R* of a convex body against a wall, whose curvature does not count.
template <class Law, class Real>
Real contact_radius(const Law& law, const SupportSampleOf<Real>& i, const Real& d_eq_i) {
    if (law.geometry.radius == ContactLaw::Radius::equivalent) return 0.5 * d_eq_i;
    return mean_curvature_radius(i, d_eq_i);
}

/// Effective mass along the common normal. The lever of a body of revolution and the normal lie in
/// a plane with its axis, so their product turns it about a transverse axis alone.
template <class Pair, class Law>
typename Pair::Real inverse_mass_at(const Pair& pair, const Law& law, const Vec3In<Pair>& n,
                                    const Vec3In<Pair>& r_i) {
    typename Pair::Real inverse = inverse_reduced_mass(pair);
    if (law.damping_mass == ContactLaw::DampingMass::contact) {
        const Vec3In<Pair> r_j = r_i - pair.displacement;
        inverse += pair.i.inverse_inertia.moments.x() * r_i.cross(n).squaredNorm() +
                   pair.j.inverse_inertia.moments.x() * r_j.cross(n).squaredNorm();
    }
    return inverse;
}

/// What two bodies do to each other where they share a normal.
template <class Pair, class Law, class History>
typename Pair::Contact force_at(const CommonNormalOf<typename Pair::Real>& at,
                                const typename Pair::Real& local_radius, const Pair& pair,
                                const Law& law, double dt, History& history) {
    using Real = typename Pair::Real;
    PointMotionOf<Pair> motion = motion_at(pair, at.middle, -at.n, at.f);
    motion.inverse_mass = inverse_mass_at(pair, law, at.n, at.middle);
    const PointForceOf<Real> f = point_force(motion, local_radius, law, dt, history);

    auto contact = point_contact<typename Pair::Contact>(f, at.f, at.middle, Vec3In<Pair>(-at.n));
    contact.force = f.tangential - f.normal * at.n;
    contact.torque_i += at.middle.cross(contact.force);
    contact.torque_j += (pair.displacement - at.middle).cross(contact.force);
    return contact;
}

}  // namespace dem::runtime
