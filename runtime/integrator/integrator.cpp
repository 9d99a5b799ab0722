// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrator/integrator.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "runtime/lane_width.hpp"
#include "runtime/loop_grain.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

void update_angular_velocity(Particles& p, std::size_t i, const BodyKind& kind) {
    p.angular_velocity[i] =
        angular_velocity(p.orientation[i], p.angular_momentum[i], kind.inverse_inertia.moments);
}

/// Whether forces move a body of this kind.
bool is_free(const BodyKind& kind) {
    return kind.inverse_inertia.mass > 0.0;
}

void kick(Particles& p, std::size_t i, const BodyKind& kind, double h) {
    if (!is_free(kind)) return;
    p.velocity[i] += h * kind.inverse_inertia.mass * p.force[i];
    p.angular_momentum[i] += h * p.torque[i];
}

void drift(Particles& p, std::size_t i, const BodyKind& kind, double reach, double dt) {
    const Vec3& m = kind.inverse_inertia.moments;
    double speed = p.velocity[i].norm();
    if (reach > 0.0) speed += reach * largest_spin(p.angular_momentum[i], m);
    p.travel[i] += speed * dt;
    p.position[i] += dt * p.velocity[i];
    p.orientation[i] = rotated(p.orientation[i], p.angular_momentum[i], m, dt);
}

void correct(Particles& p, std::size_t i, const BodyKind& kind, double dt) {
    if (is_free(kind)) {
        p.velocity[i] += 0.5 * dt * kind.inverse_inertia.mass * (p.force[i] - p.old_force[i]);
        p.angular_momentum[i] += 0.5 * dt * (p.torque[i] - p.old_torque[i]);
    }
    update_angular_velocity(p, i, kind);
}

template <class Vector>
double* numbers(std::vector<Vector>& vectors) {
    return vectors.empty() ? nullptr : vectors.front().data();
}

BodyArrays arrays(Particles& p, const Integrator& integrator) {
    double* const orientation = p.orientation.empty() ? nullptr : p.orientation[0].coeffs().data();
    return {numbers(p.position),
            orientation,
            numbers(p.velocity),
            numbers(p.angular_momentum),
            numbers(p.angular_velocity),
            numbers(p.force),
            numbers(p.torque),
            numbers(p.old_force),
            numbers(p.old_torque),
            p.travel.data(),
            p.kind.data(),
            integrator.kinds.data()};
}

/// Every body by the kernel, and one(i) for those that it leaves.
template <class One>
void for_each_body(Particles& particles, const Integrator& integrator, BodyKernel kernel, double dt,
                   const One& one) {
    if (kernel == nullptr) {
        share_each(particles.size(), bodies_at_a_time, one);
        return;
    }
    const BodyArrays bodies = arrays(particles, integrator);
    share_loop(particles.size(), bodies_at_a_time, [&](const LoopPart& part) {
        for (std::size_t first = part.begin; first < part.end; first += body_block) {
            const std::size_t count = std::min(part.end - first, body_block);
            const std::uint64_t moved = kernel(bodies, first, count, dt);
            for (std::size_t k = 0; k < count; ++k)
                if ((moved >> k & 1) == 0) one(first + k);
        }
    });
}

}  // namespace

Integrator make_integrator(const Scene& scene, std::span<const double> surface_reach) {
    Integrator integrator{{}, &body_kernels(lane_width(scene))};
    for (std::size_t k = 0; k < scene.kinds.size(); ++k) {
        const InverseInertia& inverse = scene.kinds[k].inverse_inertia;
        const Vec3& m = inverse.moments;
        integrator.kinds.push_back(
            {inverse.mass, m.x(), m.z(), surface_reach[k], m.x() == m.y() ? 1.0 : 0.0});
    }
    return integrator;
}

void advance(Particles& particles, std::span<const BodyKind> kinds, const Integrator& integrator,
             double dt) {
    for_each_body(particles, integrator, integrator.kernels->advance, dt, [&](std::size_t i) {
        const std::uint32_t kind = particles.kind[i];
        kick(particles, i, kinds[kind], 0.5 * dt);
        drift(particles, i, kinds[kind], integrator.kinds[kind].reach, dt);
        kick(particles, i, kinds[kind], 0.5 * dt);
        update_angular_velocity(particles, i, kinds[kind]);
    });
}

void correct(Particles& particles, std::span<const BodyKind> kinds, const Integrator& integrator,
             double dt) {
    for_each_body(particles, integrator, integrator.kernels->correct, dt,
                  [&](std::size_t i) { correct(particles, i, kinds[particles.kind[i]], dt); });
}

}  // namespace dem::runtime
