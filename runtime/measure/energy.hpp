// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <cstdint>

namespace dem::runtime {

class Simulation;

/// Where the energy of a simulation is. Fixed bodies have none.
///
///     kinetic + potential + elastic + dissipated + removed - wall_work - inserted = 0
///
/// but for the error of the time integration.
struct Energies {
    double translational = 0.0;  ///< kinetic [J]
    double rotational = 0.0;     ///< kinetic [J]
    double elastic = 0.0;        ///< in the springs of contacts [J]
    double potential = 0.0;      ///< in gravity, 0 at the origin [J]
    double dissipated = 0.0;     ///< by dashpots and slip since time 0 [J]
    double wall_work = 0.0;      ///< done by moving walls since time 0 [J]
    double inserted = 0.0;       ///< kinetic and potential energy of all bodies when new [J]
    double removed = 0.0;        ///< energy of the bodies taken out and of their contacts [J]

    double residual() const {
        return translational + rotational + elastic + potential + dissipated + removed - wall_work -
               inserted;
    }
};

/// Sums in the order of ids and of pairs.
Energies energies(const Simulation& simulation);

/// Kinetic and potential energy of body i [J].
double mechanical_energy(const Particles& particles, const Scene& scene, std::uint32_t i);

}  // namespace dem::runtime
