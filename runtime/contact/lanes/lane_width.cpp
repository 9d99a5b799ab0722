// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each width, for the processors whose registers are as wide (CMakeLists.txt).
// Nothing here may leave a function behind that other files share, or the linker might keep the
// copy that only newer processors understand: all is in templates of Real or has no name outside.
#include "runtime/contact/lanes/lane_types.hpp"
#include "runtime/contact/lanes/lane_widths.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/smooth/rival_normal.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"

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

LaneInertia<Real> inertia(const Group& group, const LaneKind* LaneContact::*kind) {
    const Real moment = each(group, [&](const auto& c) { return (c.*kind)->inverse_moment; });
    return {each(group, [&](const auto& c) { return (c.*kind)->inverse_mass; }),
            {moment, moment, moment},
            each(group, [&](const auto& c) { return (c.*kind)->inverse_surface; })};
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

Vector each_stored(const Group& group, StoredVec3 PointHistory::*of) {
    return {each(group, [&](const auto& c) { return (c.history->*of).x; }),
            each(group, [&](const auto& c) { return (c.history->*of).y; }),
            each(group, [&](const auto& c) { return (c.history->*of).z; })};
}

LaneHistory<Real> history(const Group& group) {
    const auto of = [&](double PointHistory::*quantity) {
        return each(group, [&](const auto& c) { return c.history->*quantity; });
    };
    return {each_stored(group, &PointHistory::normal),
            of(&PointHistory::effective_radius),
            of(&PointHistory::phase),
            of(&PointHistory::dissipated),
            each_stored(group, &PointHistory::spring),
            of(&PointHistory::stiffness)};
}

LaneLaw<Real> law(const Group& group) {
    const ContactLaw& first = *group[0]->law;
    const auto of = [&](double ContactLaw::*quantity) {
        return each(group, [&](const auto& c) { return c.law->*quantity; });
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

void store(const LanePairContact<Real>& contact, const LaneHistory<Real>& now, std::size_t l,
           const LaneContact& c) {
    c.result->force = lane(contact.force, l);
    c.result->torque_i = lane(contact.torque_i, l);
    c.result->torque_j = lane(contact.torque_j, l);
    c.result->elastic_energy = contact.elastic_energy[l];
    c.result->dissipated_energy = contact.dissipated_energy[l];
    c.result->wall_work = 0.0;
    c.history->normal = lane(now.normal, l);
    c.history->effective_radius = now.effective_radius[l];
    c.history->phase = now.phase[l];
    c.history->dissipated = now.dissipated[l];
    c.history->spring = lane(now.spring, l);
    c.history->stiffness = now.stiffness[l];
}

/// What a kernel finds out about a group: whose lanes hold a contact that collide() would find,
/// too.
struct Computed {
    Mask is_done;
    LanePairContact<Real> contact;
};

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
            store(computed.contact, now, l, *group[l]);
        }
    }
}

// ---- The kernels.

void spheres(std::span<const LaneContact> contacts, double dt, LaneOutcome& outcome) {
    for_each_group(contacts, outcome, [&](const Group& group, LaneHistory<Real>& now) -> Computed {
        const LanePair<Real> state = pair(group);
        const Real radius_i = each(group, [](const auto& c) { return c.kind_i->bounding_radius; });
        const Real radius_j = each(group, [](const auto& c) { return c.kind_j->bounding_radius; });
        const Real distance2 = state.displacement.squaredNorm();
        const Mask touches = distance2 < square(Real(radius_i + radius_j));
        return {touches, sphere_force<Partner::sphere>(
                             touching_spheres(radius_i, radius_j, state.displacement, distance2),
                             state, law(group), dt, now)};
    });
}

struct Bounds {
    Real shortest_radius, ball_slope, inner_radius;
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
        return {of(&SupportBounds::shortest_radius), of(&SupportBounds::ball_slope),
                of(&SupportBounds::inner_radius)};
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
        const auto sizes = [&](double LaneKind::*size) {
            return std::array{each(group, [&](const auto& c) { return c.kind_i->*size; }),
                              each(group, [&](const auto& c) { return c.kind_j->*size; })};
        };
        const Vector& d = state.displacement;
        const Real distance = d.norm();
        const auto bounding = sizes(&LaneKind::bounding_radius);

        const NormalStepOf<Real> step = followed_step<Real>(i, j, d, distance, -now.normal);
        const NormalProbeOf<Real>& p = step.from;
        const CommonNormalOf<Real> at = extrapolated(p, step.step.turn, d);
        Mask is_done = both(no(distance > bounding[0] + bounding[1]), step.is_close);
        is_done = both(both(is_done, at.f > 0.0), is_least(p, i, j, d));
        if (!any(is_done)) return {is_done, LanePairContact<Real>{}};

        Real radius{};
        if (any(needs_local_radius(laws, now))) {
            const auto d_eq = sizes(&LaneKind::equivalent_diameter);
            radius = contact_radius(laws, i(at.n), d_eq[0], j(-at.n), d_eq[1]);
        }
        return {is_done, force_at(at, radius, state, laws, dt, now)};
    });
}

}  // namespace

#define DEM_JOINED(a, b) a##b
#define DEM_NAME(name, width) DEM_JOINED(name, width)
const LaneKernels& DEM_NAME(lane_kernels_, DEM_LANE_WIDTH)() {
    static const LaneKernels kernels{DEM_LANE_WIDTH, spheres, smooth};
    return kernels;
}

}  // namespace dem::runtime
