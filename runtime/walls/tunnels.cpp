// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/tunnels.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/loop_grain.hpp"

#include <algorithm>
#include <atomic>

namespace dem::runtime {

namespace {

struct Inscribed {
    InscribedBall operator()(const Sphere& sphere) const { return {Vec3::Zero(), sphere.radius}; }
    InscribedBall operator()(const Clump& clump) const {
        const auto largest = std::max_element(
            clump.spheres.begin(), clump.spheres.end(),
            [](const ClumpSphere& a, const ClumpSphere& b) { return a.radius < b.radius; });
        return {largest->center(), largest->radius};
    }
    /// Those that are not convex do not meet mesh walls.
    InscribedBall operator()(const SrShape& shape) const {
        const double inner = shape.support.bounds.inner_radius;
        return {Vec3::Zero(), shape.is_convex && inner > 0.0 ? inner : infinite};
    }
    /// Does not meet mesh walls.
    InscribedBall operator()(const ConvexShape& /*shape*/) const {
        return {Vec3::Zero(), infinite};
    }
};

Vec3 in_wall(const WallState& state, const Vec3& x) {
    return state.body.orientation.conjugate() * (x - state.position);
}

}  // namespace

TunnelWatch::TunnelWatch(const Scene& scene)
    : least_distance_(std::max(0.0, 1.0 - scene.run.overlap_limit)) {
    for (std::uint32_t w = 0; w < scene.walls.size(); ++w)
        if (std::holds_alternative<MeshWall>(scene.walls[w].shape)) walls_.push_back(w);
    for (const BodyKind& kind : scene.kinds)
        balls_.push_back(std::visit(Inscribed{}, scene.shapes[kind.shape].shape));
}

bool TunnelWatch::is_fast(const Bodies& bodies, std::uint32_t particle, double dt) const {
    const Particles& p = bodies.particles;
    const InscribedBall& ball = balls_[p.kind[particle]];
    const double least = least_distance_ * ball.radius;
    const double speed =
        p.velocity[particle].norm() + p.angular_velocity[particle].norm() * ball.center.norm();
    return std::any_of(walls_.begin(), walls_.end(), [&](std::uint32_t w) {
        const WallState& wall = bodies.walls.state[w];
        const double wall_speed =
            wall.body.velocity.norm() +
            wall.body.angular_velocity.norm() * (p.position[particle] - wall.position).norm();
        return !((speed + wall_speed) * dt < least);
    });
}

std::optional<std::uint32_t> TunnelWatch::crossed_wall(const Bodies& bodies, std::uint32_t particle,
                                                       double time, double dt) const {
    const Particles& p = bodies.particles;
    if (bodies.kind(particle).inverse_inertia.mass == 0.0) return std::nullopt;
    const Vec3 lever = p.orientation[particle] * balls_[p.kind[particle]].center;
    const Vec3 now = p.position[particle] + lever;
    const Vec3 before =
        now - dt * (p.velocity[particle] + p.angular_velocity[particle].cross(lever));
    for (const std::uint32_t w : walls_) {
        const Wall& wall = bodies.scene.walls[w];
        const WallMesh& mesh = *std::get<MeshWall>(wall.shape).mesh;
        const Vec3 from = in_wall(wall_state(wall, {time - dt, bodies.walls.settled}), before);
        const Vec3 to = in_wall(bodies.walls.state[w], now);
        if (first_crossed(mesh, from, to) < mesh.triangles.size()) return w;
    }
    return std::nullopt;
}

std::optional<TunnelWatch::Tunnel> TunnelWatch::find(const Bodies& bodies, double time,
                                                     double dt) const {
    if (walls_.empty()) return std::nullopt;
    std::atomic<bool> is_any_fast = false;
    share_loop(bodies.particles.size(), bodies_at_a_time, [&](const LoopPart& part) {
        bool is_one_fast = false;
        for (std::size_t i = part.begin; i < part.end; ++i)
            is_one_fast = is_one_fast || is_fast(bodies, static_cast<std::uint32_t>(i), dt);
        if (is_one_fast) is_any_fast = true;
    });
    if (!is_any_fast) return std::nullopt;
    for (std::uint32_t i = 0; i < bodies.particles.size(); ++i) {
        if (!is_fast(bodies, i, dt)) continue;
        if (const auto wall = crossed_wall(bodies, i, time, dt)) return Tunnel{i, *wall};
    }
    return std::nullopt;
}

}  // namespace dem::runtime
