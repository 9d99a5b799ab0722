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
    LaneKind lane;
    lane.inverse_mass = kind.inverse_inertia.mass;
    lane.inverse_moment = kind.inverse_inertia.moments.x();
    lane.inverse_surface = kind.inverse_inertia.surface;
    lane.radius = shape.bounding_radius;
    if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) lane.radius = sphere->radius;
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) {
        lane.radius = sr->bounding_radius;
        lane.equivalent_diameter = sr->equivalent_diameter;
        lane.support = &sr->support;
    }
    return lane;
}

LaneKind lane_kind(const WallShape& wall) {
    LaneKind lane;
    if (const auto* plane = std::get_if<PlaneWall>(&wall)) lane.radius = plane->radius;
    if (const auto* cylinder = std::get_if<CylinderWall>(&wall)) {
        lane.radius = cylinder->radius;
        lane.length = cylinder->length;
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

LaneRow row(const Vec3& position, const Quat& orientation, const Vec3& velocity,
            const Vec3& angular_velocity) {
    return {plain(position), plain(body_axis(orientation)), plain(velocity),
            plain(angular_velocity)};
}

}  // namespace

LaneBodies make_lane_bodies(const Scene& scene) {
    const auto& laws = scene.laws.all();
    const bool alike = std::all_of(laws.begin(), laws.end(), [&](const ContactLaw& law) {
        return choose_alike(law, laws.front());
    });
    LaneBodies lanes;
    lanes.kernels = lane_kernels(alike ? lane_width(scene) : 1);
    for (const BodyKind& kind : scene.kinds) lanes.kinds.push_back(lane_kind(scene, kind));
    for (const Wall& wall : scene.walls) lanes.wall_kinds.push_back(lane_kind(wall.shape));
    return lanes;
}

void update(LaneBodies& lanes, const Particles& particles, const MovingWalls& walls) {
    lanes.rows.resize(particles.size());
    share_each(particles.size(), bodies_at_a_time, [&](std::size_t i) {
        lanes.rows[i] = row(particles.position[i], particles.orientation[i], particles.velocity[i],
                            particles.angular_velocity[i]);
    });
    lanes.wall_rows.clear();
    for (const WallState& wall : walls.state) {
        const BodyState& body = wall.body;
        lanes.wall_rows.push_back(
            row(wall.position, body.orientation, body.velocity, body.angular_velocity));
    }
}

}  // namespace dem::runtime
