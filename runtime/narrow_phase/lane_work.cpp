// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/lane_work.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/lane_width.hpp"
#include "runtime/loop_grain.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

LaneKind lane_kind(const Scene& scene, const BodyKind& kind) {
    const ParticleTemplate& shape = scene.shapes[kind.shape];
    LaneKind lane{kind.inverse_inertia.mass,
                  kind.inverse_inertia.moments.x(),
                  kind.inverse_inertia.surface,
                  shape.bounding_radius,
                  0.0,
                  nullptr};
    if (const auto* sphere = std::get_if<Sphere>(&shape.shape))
        lane.bounding_radius = sphere->radius;
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) {
        lane.bounding_radius = sr->bounding_radius;
        lane.equivalent_diameter = sr->equivalent_diameter;
        lane.support = &sr->support;
    }
    return lane;
}

/// Whether two laws choose alike what all lanes of a group must.
bool choose_alike(const ContactLaw& a, const ContactLaw& b) {
    return a.model == b.model && a.tangential == b.tangential && a.damping_mass == b.damping_mass &&
           a.limit_force == b.limit_force && a.geometry.radius == b.geometry.radius;
}

std::array<double, 3> plain(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

LaneBodies make_lane_bodies(const Scene& scene) {
    const auto& laws = scene.laws.all();
    const bool alike = std::all_of(laws.begin(), laws.end(), [&](const ContactLaw& law) {
        return choose_alike(law, laws.front());
    });
    LaneBodies lanes{lane_kernels(alike ? lane_width(scene) : 1), {}, {}};
    for (const BodyKind& kind : scene.kinds) lanes.kinds.push_back(lane_kind(scene, kind));
    return lanes;
}

void update(LaneBodies& lanes, const Particles& particles) {
    lanes.rows.resize(particles.size());
    share_each(particles.size(), bodies_at_a_time, [&](std::size_t i) {
        lanes.rows[i] = {plain(particles.position[i]), plain(body_axis(particles.orientation[i])),
                         plain(particles.velocity[i]), plain(particles.angular_velocity[i])};
    });
}

}  // namespace dem::runtime
