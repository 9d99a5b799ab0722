// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <span>

/// Velocity Verlet [SR] Eqs. 20-21 for all bodies (docs/time-integration.md). One step of the time
/// loop is: kick by dt/2, drift, predict, forces, correct. A body of zero inverse inertia keeps its
/// velocity and does not turn.
namespace dem::runtime {

/// v += h F/m, L += h T with the stored force and torque.
void kick(Particles& particles, std::span<const BodyKind> kinds, double h);

/// x += dt v; the orientation turns freely with L. Adds to `travel`. `bounding_radius`, per kind:
/// how far surface points can lie from the center of mass [m]; 0 for spheres, whose surface does
/// not move when they turn. The angular velocity is left to `predict`.
void drift(Particles& particles, std::span<const BodyKind> kinds,
           std::span<const double> bounding_radius, double dt);

/// The second half kick with the force of the step before, so that dashpots see velocities at
/// t + dt and the scheme stays of second order; then the angular velocities.
void predict(Particles& particles, std::span<const BodyKind> kinds, double dt);

/// Makes the predicted half kick the right one: v += dt/2 (F - F_old)/m, the same for L and T; then
/// the angular velocities.
void correct(Particles& particles, std::span<const BodyKind> kinds, double dt);

}  // namespace dem::runtime
