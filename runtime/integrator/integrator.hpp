// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/integrator/body_lanes.hpp"
#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <span>
#include <vector>

/// Velocity Verlet [SR] Eqs. 20-21 for all bodies (docs/time-integration.md). One step of the time
/// loop is: kick by dt/2, drift, predict, forces, correct. A body of zero inverse inertia keeps its
/// velocity and does not turn.
namespace dem::runtime {

/// What moves the kinds of bodies of a scene, and how many bodies are moved at a time.
struct Integrator {
    std::vector<KindMotion> kinds;
    const BodyKernels* kernels;
};
/// `surface_reach`, per kind: how far surface points can lie from the center of mass [m]; 0 for
/// spheres, whose surface does not move when they turn.
Integrator make_integrator(const Scene& scene, std::span<const double> surface_reach);

/// The first three lines of a step, body by body:
///   kick     v += dt/2 F/m, L += dt/2 T with the stored force and torque;
///   drift    x += dt v; the orientation turns freely with L. Adds to `travel`;
///   predict  the second half kick with the force of the step before, so that dashpots see
///            velocities at t + dt and the scheme stays of second order; the angular velocities.
void advance(Particles& particles, std::span<const BodyKind> kinds, const Integrator& integrator,
             double dt);

/// Makes the predicted half kick the right one: v += dt/2 (F - F_old)/m, the same for L and T; then
/// the angular velocities.
void correct(Particles& particles, std::span<const BodyKind> kinds, const Integrator& integrator,
             double dt);

}  // namespace dem::runtime
