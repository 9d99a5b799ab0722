// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each width, for the processors whose registers are as wide (CMakeLists.txt).
// Nothing here may leave a function behind that other files share, or the linker might keep the
// copy that only newer processors understand: all is in templates of Real or has no name outside.
#include "runtime/contact/lanes/lane_types.hpp"
#include "runtime/contact/lanes/lane_widths.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/smooth/plane_place.hpp"
#include "runtime/contact/smooth/rival_normal.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"
#include "runtime/contact/smooth/tube_place.hpp"
#include "runtime/contact/walls/wall_work.hpp"

namespace dem::runtime {

namespace {

using Real = Lanes<DEM_LANE_WIDTH>;
using Vector = Vec3Of<Real>;
using Mask = MaskOf<Real>;
using Group = LaneGroup<Real>;
constexpr std::size_t width = DEM_LANE_WIDTH;

// ---- Filling lanes.

template <class Of>
Real each(const Group& group, const Of& of) {
    Real r;
    for (std::size_t l = 0; l < width; ++l) r[l] = of(*group[l]);
    return r;
}

template <class Of>
Vector each_vector(const Group& group, const Of& of) {
    return {each(group, [&](const LaneContact& c) { return of(c)[0]; }),
            each(group, [&](const LaneContact& c) { return of(c)[1]; }),
            each(group, [&](const LaneContact& c) { return of(c)[2]; })};
}

/// A quantity of what all contacts point at, mostly one for all of them.
template <class Pointed>
Real each(const Group& group, const Pointed* LaneContact::*what, double Pointed::*quantity) {
    const Pointed* const first = group[0]->*what;
    bool is_one = true;
    for (const LaneContact* c : group) is_one = is_one && c->*what == first;
    if (is_one) return in_all<Real>(first->*quantity);
    return each(group, [&](const LaneContact& c) { return (c.*what)->*quantity; });
}

LaneInertia<Real> inertia(const Group& group, const LaneKind* LaneContact::*kind) {
    const Real moment = each(group, kind, &LaneKind::inverse_moment);
    return {each(group, kind, &LaneKind::inverse_mass),
            {moment, moment, moment},
            each(group, kind, &LaneKind::inverse_surface)};
}

LaneBody<Real> body(const Group& group, const LaneRow* LaneContact::*row,
                    const LaneKind* LaneContact::*kind) {
    return {each_vector(
                group, [&](const auto& c) -> const auto& { return (c.*row)->axis; }),
            each_vector(
                group, [&](const auto& c) -> const auto& { return (c.*row)->velocity; }),
            each_vector(
                group, [&](const auto& c) -> const auto& { return (c.*row)->angular_velocity; }),
            inertia(group, kind)};
}

LanePair<Real> pair(const Group& group) {
    const Vector x_i = each_vector(
        group, [](const auto& c) -> const auto& { return c.i->position; });
    const Vector x_j = each_vector(
        group, [](const auto& c) -> const auto& { return c.j->position; });
    return {x_j - x_i, body(group, &LaneContact::i, &LaneContact::kind_i),
            body(group, &LaneContact::j, &LaneContact::kind_j)};
}

template <class Of>
Vector each_stored(const Group& group, const Of& of) {
    return {each(group, [&](const LaneContact& c) { return of(c).x; }),
            each(group, [&](const LaneContact& c) { return of(c).y; }),
            each(group, [&](const LaneContact& c) { return of(c).z; })};
}

LaneHistory<Real> history(const Group& group) {
    const auto of = [&](double ContactHistory::*quantity) {
        return each(group, [&](const auto& c) { return c.history->*quantity; });
    };
    return {each_stored(
                group, [](const auto& c) -> const auto& { return c.history->normal; }),
            of(&ContactHistory::effective_radius),
            of(&ContactHistory::phase),
            of(&ContactHistory::dissipated),
            each_stored(
                group, [](const auto& c) -> const auto& { return c.spring->spring; }),
            each(group, [](const auto& c) { return c.spring->stiffness; })};
}

LaneLaw<Real> law(const Group& group) {
    const ContactLaw& first = *group[0]->law;
    const auto of = [&](double ContactLaw::*quantity) {
        return each(group, &LaneContact::law, quantity);
    };
    return {first.geometry,
            first.model,
            first.tangential,
            first.damping_mass,
            first.limit_force,
            of(&ContactLaw::youngs_modulus),
            of(&ContactLaw::shear_modulus),
            of(&ContactLaw::damping),
            of(&ContactLaw::friction),
            of(&ContactLaw::stiffness_ratio),
            of(&ContactLaw::damping_ratio),
            of(&ContactLaw::normal_stiffness),
            of(&ContactLaw::tangential_stiffness),
            of(&ContactLaw::tangential_damping)};
}

// ---- Emptying them.

StoredVec3 lane(const Vector& v, std::size_t l) {
    StoredVec3 stored;
    stored.x = v.x_[l];
    stored.y = v.y_[l];
    stored.z = v.z_[l];
    return stored;
}

/// What a kernel finds out about a group: which lanes hold a contact that collide() would find,
/// too.
struct Computed {
    Mask is_done;
    LanePairContact<Real> contact;
    Real wall_work{};  ///< [J]
    Real shear{};      ///< friction of a wall [N]
};

void store(const Computed& computed, const LaneHistory<Real>& now, std::size_t l,
           const LaneContact& c) {
    const LanePairContact<Real>& contact = computed.contact;
    c.result->force = lane(contact.force, l);
    c.result->torque_i = lane(contact.torque_i, l);
    c.result->torque_j = lane(contact.torque_j, l);
    c.result->elastic_energy = contact.elastic_energy[l];
    c.result->dissipated_energy = contact.dissipated_energy[l];
    c.result->wall_work = computed.wall_work[l];
    if (c.parts != nullptr) *c.parts = {contact.normal_force[l], computed.shear[l]};
    c.history->normal = lane(now.normal, l);
    c.history->effective_radius = now.effective_radius[l];
    c.history->phase = now.phase[l];
    c.history->dissipated = now.dissipated[l];
    c.spring->spring = lane(now.spring, l);
    c.spring->stiffness = now.stiffness[l];
}

template <class Compute>
void for_each_group(std::span<const LaneContact> contacts, LaneOutcome& outcome,
                    const Compute& compute) {
    outcome.done = 0;
    for (std::size_t first = 0; first < contacts.size(); first += width) {
        const std::size_t count = contacts.size() - first < width ? contacts.size() - first : width;
        Group group;
        for (std::size_t l = 0; l < width; ++l)
            group[l] = contacts.data() + first + (l < count ? l : count - 1);
        LaneHistory<Real> now = history(group);
        const Computed computed = compute(group, now);
        for (std::size_t l = 0; l < count; ++l) {
            if (computed.is_done[l] == 0) continue;
            outcome.done |= std::uint64_t{1} << (first + l);
            outcome.overlap[first + l] = computed.contact.overlap[l];
            store(computed, now, l, *group[l]);
        }
    }
}

// ---- The kernels.

Real size_i(const Group& group, double LaneKind::*size) {
    return each(group, &LaneContact::kind_i, size);
}
Real size_j(const Group& group, double LaneKind::*size) {
    return each(group, &LaneContact::kind_j, size);
}

void spheres(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) -> Computed {
        const LanePair<Real> state = pair(group);
        const Real radius_i = size_i(group, &LaneKind::radius);
        const Real radius_j = size_j(group, &LaneKind::radius);
        const Real distance2 = state.displacement.squaredNorm();
        const Mask touches = distance2 < square(Real(radius_i + radius_j));
        return {touches, sphere_force<Partner::sphere>(
                             touching_spheres(radius_i, radius_j, state.displacement, distance2),
                             state, law(group), dt, now)};
    });
}

template <class Field>
Computed sphere_in(const Field& field, const LanePair<Real>& state, const Group& group, double dt,
                   LaneHistory<Real>& now) {
    const Real radius = size_i(group, &LaneKind::radius);
    const auto here = field.sample(Vector::Zero());
    const LanePairContact<Real> contact = sphere_force<Partner::wall>(
        sphere_at_wall(field, here, radius), state, law(group), dt, now);
    return {touches_wall(field, here, radius), contact, wall_work(state, contact, dt),
            contact.friction.norm()};
}

PlaneFieldOf<Real> plane(const LanePair<Real>& state, const Group& group) {
    return {{0.0}, {state.displacement, state.j.axis}, size_j(group, &LaneKind::radius)};
}

void sphere_at_plane(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) {
        const LanePair<Real> state = pair(group);
        return sphere_in(plane(state, group), state, group, dt, now);
    });
}

void sphere_in_tube(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) {
        const LanePair<Real> state = pair(group);
        const TubeFieldOf<Real> tube{{0.0},
                                     {state.displacement, state.j.axis},
                                     size_j(group, &LaneKind::radius),
                                     size_j(group, &LaneKind::length)};
        return sphere_in(tube, state, group, dt, now);
    });
}

struct Bounds {
    Real longest_radius, shortest_radius, ball_slope, inner_radius;
};

/// SrSupport in each lane.
struct Support {
    const Group& group;
    const LaneKind* LaneContact::*kind;
    Vector axis;

    const SupportMap& map(std::size_t l) const { return *(group[l]->*kind)->support; }

    SupportSampleOf<Real> operator()(const Vector& n) const {
        const AxialDirection<Real> direction = axial_direction<Real>(n, axis);
        SupportPieceOf<Real> piece;
        Real room;
        for (std::size_t l = 0; l < width; ++l) {
            std::uint32_t index = 0;
            double room_here = no_jump;
            if (map(l).pieces.size() > 1)
                SrSupport::find_piece(map(l), direction.n_r[l], direction.u[l], index, room_here);
            const SupportPiece& p = map(l).pieces[index];
            piece.center_r[l] = p.center_r;
            piece.center_z[l] = p.center_z;
            piece.a[l] = p.a;
            piece.b[l] = p.b;
            room[l] = room_here;
        }
        return support_on(piece, direction, room);
    }

    Bounds bounds() const {
        const auto of = [&](double SupportBounds::*bound) {
            return each(group, [&](const auto& c) { return (c.*kind)->support->bounds.*bound; });
        };
        return {of(&SupportBounds::longest_radius), of(&SupportBounds::shortest_radius),
                of(&SupportBounds::ball_slope), of(&SupportBounds::inner_radius)};
    }
};

Mask needs_local_radius(const LaneLaw<Real>& law, const LaneHistory<Real>& now) {
    const Mask always = Real{} < 1.0;
    if (law.geometry.radius == ContactLaw::Radius::local) return always;
    if (law.geometry.radius == ContactLaw::Radius::equivalent) return no(always);
    return now.phase >= settled_phase + drift_interval;
}

void smooth(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) -> Computed {
        const LanePair<Real> state = pair(group);
        const LaneLaw<Real> laws = law(group);
        const Support i{group, &LaneContact::kind_i, state.i.axis};
        const Support j{group, &LaneContact::kind_j, state.j.axis};
        const Vector& d = state.displacement;
        const Real distance = d.norm();
        const Real reach = size_i(group, &LaneKind::radius) + size_j(group, &LaneKind::radius);
        const NormalStepOf<Real> step = followed_step<Real>(i, j, d, distance, -now.normal);
        const NormalProbeOf<Real>& p = step.from;
        const CommonNormalOf<Real> at = extrapolated(p, step.step.turn, d);
        Mask is_done = both(no(distance > reach), step.is_close);
        is_done = both(both(is_done, at.f > 0.0), is_least(p, i, j, d));
        if (!any(is_done)) return {is_done, LanePairContact<Real>{}};

        Real radius{};
        if (any(needs_local_radius(laws, now))) {
            radius = contact_radius(laws, i(at.n), size_i(group, &LaneKind::equivalent_diameter),
                                    j(-at.n), size_j(group, &LaneKind::equivalent_diameter));
        }
        return {is_done, force_at(at, radius, state, laws, dt, now)};
    });
}

/// Force of a wall on a surface of revolution at a place near that of a sample.
Computed smooth_at_wall(const CommonNormalOf<Real>& at, const SupportSampleOf<Real>& sample,
                        const LanePair<Real>& state, const Group& group, double dt,
                        LaneHistory<Real>& now) {
    const LaneLaw<Real> laws = law(group);
    Real radius{};
    if (any(needs_local_radius(laws, now)))
        radius = contact_radius(laws, sample, size_i(group, &LaneKind::equivalent_diameter));
    const LanePairContact<Real> contact = force_at(at, radius, state, laws, dt, now);
    return {at.f > 0.0, contact, wall_work(state, contact, dt), contact.friction.norm()};
}

void smooth_at_plane(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) {
        const LanePair<Real> state = pair(group);
        const Support body{group, &LaneContact::kind_i, state.i.axis};
        const Vector& n = state.j.axis;
        const Real height = -state.displacement.dot(n);
        const Real size = size_i(group, &LaneKind::radius);
        const auto [at, sample] = place_at_plane<Real>(body, n, height);
        const Vector spin = dt * (state.i.angular_velocity - state.j.angular_velocity);
        const PlaneSwing<Real> swing = plane_swing<Real>(body.axis, n, spin);
        const PlaneFieldOf<Real> field = plane(state, group);
        const Mask acts =
            both(field.accepts(sample.point(-n)), no(field.lets_pass(Vector::Zero())));
        const Mask stays = both(no(height > size), stays_near(sample, swing, size));
        Computed computed = smooth_at_wall(at, sample, state, group, dt, now);
        computed.is_done = both(computed.is_done, both(acts, stays));
        return computed;
    });
}

void smooth_in_tube(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) -> Computed {
        const LanePair<Real> state = pair(group);
        const Support body{group, &LaneContact::kind_i, state.i.axis};
        const TubePoseOf<Real> pose{state.j.axis, -state.displacement,
                                    size_j(group, &LaneKind::radius),
                                    size_i(group, &LaneKind::radius)};
        const TubePlaceOf<Real> place = followed_place<Real>(body, pose, now.normal);
        const Vector spin = dt * (state.i.angular_velocity - state.j.angular_velocity);
        const PlaneSwing<Real> swing =
            along_line<Real>(plane_swing<Real>(body.axis, Vector(-place.at.n), spin), state.j.axis);
        const Mask stays = stays_near(place.support, swing, pose.size);
        const Mask is_done = both(
            stays, both(place.is_only, side_reaches(size_j(group, &LaneKind::length), place.z)));
        if (!any(is_done)) return {is_done, LanePairContact<Real>{}};
        Computed computed = smooth_at_wall(place.at, place.support, state, group, dt, now);
        computed.is_done = is_done;
        return computed;
    });
}

}  // namespace

#define DEM_JOINED(a, b) a##b
#define DEM_NAME(name, width) DEM_JOINED(name, width)
const LaneKernels& DEM_NAME(lane_kernels_, DEM_LANE_WIDTH)() {
    static const LaneKernels kernels{DEM_LANE_WIDTH,  spheres,        smooth,
                                     sphere_at_plane, sphere_in_tube, smooth_at_plane,
                                     smooth_in_tube};
    return kernels;
}

}  // namespace dem::runtime
