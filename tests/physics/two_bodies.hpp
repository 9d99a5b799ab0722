// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"
#include "runtime/integrator/rigid_body.hpp"

namespace dem::test {

using namespace runtime;

struct Body {
    Vec3 position = Vec3::Zero();
    Quat orientation = Quat::Identity();
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_momentum = Vec3::Zero();
    InverseInertia inverse;
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();

    Vec3 angular_velocity() const {
        return runtime::angular_velocity(orientation, angular_momentum, inverse.moments);
    }
    double kinetic_energy() const {
        if (inverse.mass == 0.0) return 0.0;
        return 0.5 * velocity.squaredNorm() / inverse.mass +
               rotational_energy(angular_momentum, angular_velocity());
    }
    BodyState state() const { return {orientation, velocity, angular_velocity(), inverse}; }
};

inline InverseInertia inverse_inertia(double mass, const Vec3& moments) {
    return {1.0 / mass, moments.cwiseInverse()};
}
inline InverseInertia solid_sphere(double density, double radius) {
    const double mass = density * 4.0 / 3.0 * pi * cube(radius);
    return inverse_inertia(mass, Vec3::Constant(0.4 * mass * square(radius)));
}

/// Two bodies and the scheme of the time loop: kick, drift, predict, force, correct.
struct TwoBodies {
    Body i, j;
    Vec3 acceleration = Vec3::Zero();  ///< of i (gravity) [m/s^2]
    double dissipated = 0.0;           ///< [J]
    PairContact contact;

    PairState pair() const { return {j.position - i.position, i.state(), j.state()}; }

    /// `collide(pair, dt)` returns the PairContact.
    template <class Collide>
    void step(double dt, const Collide& collide) {
        for (Body* b : {&i, &j}) {
            kick(*b, 0.5 * dt);
            b->position += dt * b->velocity;
            b->orientation = rotated(b->orientation, b->angular_momentum, b->inverse.moments, dt);
        }
        const Body half_i = i;
        const Body half_j = j;
        kick(i, 0.5 * dt);
        kick(j, 0.5 * dt);
        contact = collide(pair(), dt);
        dissipated += contact.dissipated_energy;
        i.velocity = half_i.velocity;
        i.angular_momentum = half_i.angular_momentum;
        j.velocity = half_j.velocity;
        j.angular_momentum = half_j.angular_momentum;
        i.force = contact.force;
        if (i.inverse.mass > 0.0) i.force += acceleration / i.inverse.mass;
        i.torque = contact.torque_i;
        j.force = -contact.force;
        j.torque = contact.torque_j;
        kick(i, 0.5 * dt);
        kick(j, 0.5 * dt);
    }

    double kinetic_energy() const { return i.kinetic_energy() + j.kinetic_energy(); }
    double mechanical_energy() const { return kinetic_energy() + contact.elastic_energy; }

  private:
    static void kick(Body& b, double h) {
        if (b.inverse.mass == 0.0) return;
        b.velocity += h * b.inverse.mass * b.force;
        b.angular_momentum += h * b.torque;
    }
};

}  // namespace dem::test
