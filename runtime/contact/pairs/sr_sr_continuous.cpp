// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_sr_continuous.hpp"

#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/point_force.hpp"
#include "runtime/contact/smooth/rival_normal.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

namespace dem::runtime {

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

template <class SupportI, class SupportJ>
double local_radius(const Side<SupportI>& i, const Side<SupportJ>& j, const Vec3& n,
                    const ContactLaw& law) {
    return contact_radius(law, i.support(n), i.equivalent_diameter, j.support(-n),
                          j.equivalent_diameter);
}

template <class SupportI, class SupportJ>
FollowedNormal first_normal(const SupportI& i, const SupportJ& j, const Vec3& d) {
    const double distance = d.norm();
    const Vec3 start = distance > 0.0 ? Vec3(d / distance) : Vec3::UnitZ();
    const NormalProbe p = common_normal(i, j, d, start);
    return {result_of(p, d), p};
}

// ---- Bodies with edges: the least of several minima (rival_normal.hpp).

double overlap_rate(const PairState& pair, const CommonNormal& at) {
    return motion_at(pair, at.middle, -at.n, at.f).overlap_rate;
}

/// Bound of the way by which the overlap along any direction changes in a step [m].
double longest_way(const Side<SrSupport>& i, const Side<SrSupport>& j, const PairState& pair,
                   double dt) {
    return dt * ((pair.i.velocity - pair.j.velocity).norm() +
                 pair.i.angular_velocity.norm() * i.bounding_radius +
                 pair.j.angular_velocity.norm() * j.bounding_radius);
}

/// For how much of the time from half a step before now to half a step after now another minimum
/// is the least one.
double share_of_rival(const PairState& pair, double dt, const CommonNormal& least,
                      const CommonNormal& rival) {
    const double way = std::abs(overlap_rate(pair, least) - overlap_rate(pair, rival)) * dt;
    const double ahead = rival.f - least.f;
    return 2.0 * ahead < way ? 0.5 - ahead / way : 0.0;
}

/// Moves the normal force from one place to another by a share of what it is.
void share_force(double share, const CommonNormal& least, const CommonNormal& rival,
                 const SmoothCall& call, PairContact& contact) {
    const ContactLaw law = frictionless(call.law);
    const PointHistory& now = call.memory.history;
    for (const auto& [at, part] : {std::pair{least, -share}, std::pair{rival, share}}) {
        PointHistory history{};
        history.effective_radius = now.effective_radius;
        const PairContact c = force_at(at, now.effective_radius, call.pair, law, call.dt, history);
        contact.force += part * c.force;
        contact.torque_i += part * c.torque_i;
        contact.torque_j += part * c.torque_j;
        contact.dissipated_energy += part * c.dissipated_energy;
    }
}

PairContact contact_of_least(const NormalProbe& known, const Side<SrSupport>& i,
                             const Side<SrSupport>& j, const SmoothCall& call) {
    const PairState& pair = call.pair;
    const Vec3& d = pair.displacement;
    NormalProbe least = descend(i.support, j.support, d, known);
    std::optional<NormalProbe> rival =
        rival_normal(least, i.support, j.support, d, least.f + longest_way(i, j, pair, call.dt));
    if (rival && rival->f < least.f) std::swap(least, *rival);
    const CommonNormal at = result_of(least, d);
    if (!(at.f > 0.0)) return apart(call, -at.f, at.n);
    PointHistory& history = call.memory.history;
    const double radius =
        needs_local_radius(call.law, history) ? local_radius(i, j, at.n, call.law) : 0.0;
    PairContact contact = force_at(at, radius, pair, call.law, call.dt, history);
    if (!rival || !(rival->f > 0.0)) return contact;
    const CommonNormal other = result_of(*rival, d);
    const double share = share_of_rival(pair, call.dt, at, other);
    if (share > 0.0) share_force(share, at, other, call, contact);
    return contact;
}

template <class SupportI, class SupportJ>
PairContact convex_contact(const Side<SupportI>& i, const Side<SupportJ>& j,
                           const SmoothCall& call) {
    const PairState& pair = call.pair;
    auto& [history, miss] = call.memory;
    const Vec3& d = pair.displacement;
    const double distance = d.norm();
    const bool touched = history.touched();
    const double reach = i.bounding_radius + j.bounding_radius;
    const Vec3 axis = miss.axis;
    if (distance > reach) return apart(call, distance - reach, axis);

    if (!touched && axis.squaredNorm() > 0.0) {
        const NormalProbe p = common_normal(i.support, j.support, d, unit_again(axis));
        if (p.f < -NormalSearch::margin * distance) return apart(call, -p.f, p.n);
    }
    const FollowedNormal found =
        touched ? followed_normal(i.support, j.support, d, -Vec3(history.normal))
                : first_normal(i.support, j.support, d);
    const CommonNormal& at = found.at;
    if (!(at.f > 0.0)) return apart(call, -at.f, at.n);
    if constexpr (std::is_same_v<SupportI, SrSupport> && std::is_same_v<SupportJ, SrSupport>) {
        if (!is_least(found.probe, i.support, j.support, d))
            return contact_of_least(found.probe, i, j, call);
    }
    const double radius =
        needs_local_radius(call.law, history) ? local_radius(i, j, at.n, call.law) : 0.0;
    return force_at(at, radius, pair, call.law, call.dt, history);
}

}  // namespace

PairContact collide(const SrShape& a, const SrShape& b, const SmoothCall& call) {
    return convex_contact(side(a, call.pair.i), side(b, call.pair.j), call);
}

PairContact collide(const Sphere& a, const SrShape& b, const SmoothCall& call) {
    return convex_contact(side(a, call.pair.i), side(b, call.pair.j), call);
}

}  // namespace dem::runtime
