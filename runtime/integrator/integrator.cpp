// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrator/integrator.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "runtime/loop_grain.hpp"

namespace dem::runtime {

namespace {

template <class Body>
void for_each_body(const Particles& particles, const Body& body) {
    share_each(particles.size(), bodies_at_a_time, body);
}

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

}  // namespace

void kick(Particles& particles, std::span<const BodyKind> kinds, double h) {
    for_each_body(particles,
                  [&](std::size_t i) { kick(particles, i, kinds[particles.kind[i]], h); });
}

void drift(Particles& particles, std::span<const BodyKind> kinds,
           std::span<const double> bounding_radius, double dt) {
    for_each_body(particles, [&](std::size_t i) {
        Particles& p = particles;
        const Vec3& m = kinds[p.kind[i]].inverse_inertia.moments;
        double speed = p.velocity[i].norm();
        const double radius = bounding_radius[p.kind[i]];
        if (radius > 0.0) speed += radius * largest_spin(p.angular_momentum[i], m);
        p.travel[i] += speed * dt;
        p.position[i] += dt * p.velocity[i];
        p.orientation[i] = rotated(p.orientation[i], p.angular_momentum[i], m, dt);
    });
}

void predict(Particles& particles, std::span<const BodyKind> kinds, double dt) {
    for_each_body(particles, [&](std::size_t i) {
        const BodyKind& kind = kinds[particles.kind[i]];
        kick(particles, i, kind, 0.5 * dt);
        update_angular_velocity(particles, i, kind);
    });
}

void correct(Particles& particles, std::span<const BodyKind> kinds, double dt) {
    for_each_body(particles, [&](std::size_t i) {
        Particles& p = particles;
        const BodyKind& kind = kinds[p.kind[i]];
        if (is_free(kind)) {
            p.velocity[i] += 0.5 * dt * kind.inverse_inertia.mass * (p.force[i] - p.old_force[i]);
            p.angular_momentum[i] += 0.5 * dt * (p.torque[i] - p.old_torque[i]);
        }
        update_angular_velocity(p, i, kind);
    });
}

}  // namespace dem::runtime
