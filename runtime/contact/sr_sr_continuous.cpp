// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/sr_sr_continuous.hpp"

#include "runtime/contact/common_normal.hpp"
#include "runtime/contact/convex_contact.hpp"
#include "runtime/contact/wall_frame.hpp"
#include "runtime/contact_law/contact_mass.hpp"
#include "runtime/contact_law/point_force.hpp"

namespace dem {

namespace {

/// One side of the pair: support function in the world frame, and sizes.
template <class Support>
struct Side {
    Support support;
    double bounding_radius;      ///< [m]
    double equivalent_diameter;  ///< [m]
};

Side<SrSupport> side(const SrShape& shape, const BodyState& body) {
    return {{shape.support, body_axis(body.orientation)},
            shape.bounding_radius,
            shape.equivalent_diameter};
}
Side<SphereSupport> side(const Sphere& shape, const BodyState&) {
    return {{shape.radius}, shape.radius, 2.0 * shape.radius};
}

/// Effective mass along the common normal. The lever of a body of revolution and the normal lie in
/// a plane with its axis, so their product turns it about a transverse axis alone.
double inverse_mass_at(const PairState& pair, const ContactLaw& law, const Vec3& n,
                       const Vec3& r_i) {
    double inverse = inverse_reduced_mass(pair);
    if (law.damping_mass == ContactLaw::DampingMass::contact) {
        const Vec3 r_j = r_i - pair.displacement;
        inverse += pair.i.inverse_inertia.moments.x() * r_i.cross(n).squaredNorm() +
                   pair.j.inverse_inertia.moments.x() * r_j.cross(n).squaredNorm();
    }
    return inverse;
}

PairContact force_at(const CommonNormal& at, double local_radius, const PairState& pair,
                     const ContactLaw& law, double dt, PointHistory& history) {
    PointMotion motion = motion_at(pair, at.middle, -at.n, at.f);
    motion.inverse_mass = inverse_mass_at(pair, law, at.n, at.middle);
    const PointForce f = point_force(motion, local_radius, law, dt, history);

    PairContact contact;
    contact.force = f.tangential - f.normal * at.n;
    contact.torque_i = at.middle.cross(contact.force);
    contact.torque_j = (pair.displacement - at.middle).cross(contact.force);
    contact.overlap = at.f;
    contact.elastic_energy = f.elastic;
    contact.dissipated_energy = f.dissipated;
    contact.points = 1;
    return contact;
}

template <class SupportI, class SupportJ>
double local_radius(const Side<SupportI>& i, const Side<SupportJ>& j, const Vec3& n,
                    const ContactLaw& law) {
    return contact_radius(law, i.support(n), i.equivalent_diameter, j.support(-n),
                          j.equivalent_diameter);
}

template <class SupportI, class SupportJ>
PairContact convex_contact(const Side<SupportI>& i, const Side<SupportJ>& j, const PairState& pair,
                           const ContactLaw& law, double dt,
                           const ContactMemory<PointHistory>& memory) {
    PointHistory& history = memory.history;
    const Vec3& d = pair.displacement;
    const double distance = d.norm();
    const bool touched = history.effective_radius > 0.0;
    const double reach = i.bounding_radius + j.bounding_radius;
    if (distance > reach) return no_contact(memory, distance - reach, memory.miss.axis);

    if (!touched && Vec3(memory.miss.axis).squaredNorm() > 0.0) {
        const NormalProbe p = common_normal(i.support, j.support, d, memory.miss.axis);
        if (p.f < -NormalSearch::margin * distance) return no_contact(memory, -p.f, p.n);
    }
    CommonNormal at;
    if (touched) {
        at = followed_normal(i.support, j.support, d, -Vec3(history.normal));
    } else {
        const Vec3 start = distance > 0.0 ? Vec3(d / distance) : Vec3::UnitZ();
        at = result_of(common_normal(i.support, j.support, d, start), d);
    }
    if (!(at.f > 0.0)) return no_contact(memory, -at.f, at.n);
    const double radius =
        hertz::needs_local_radius(law, history) ? local_radius(i, j, at.n, law) : 0.0;
    return force_at(at, radius, pair, law, dt, history);
}

}  // namespace

PairContact collide(const SrShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ContactMemory<PointHistory>& memory) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, memory);
}

PairContact collide(const Sphere& a, const SrShape& b, const PairState& pair, const ContactLaw& law,
                    double dt, const ContactMemory<PointHistory>& memory) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, memory);
}

PairContact collide(const SrShape& a, const Sphere& b, const PairState& pair, const ContactLaw& law,
                    double dt, const ContactMemory<PointHistory>& memory) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, memory);
}

}  // namespace dem
