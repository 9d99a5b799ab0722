// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/energy.hpp"

#include "runtime/integrator/rigid_body.hpp"
#include "runtime/simulation.hpp"

namespace dem::runtime {

namespace {

void add_body(Energies& e, const Particles& p, const Scene& scene, std::uint32_t i) {
    const BodyKind& kind = scene.kinds[p.kind[i]];
    if (kind.inverse_inertia.mass == 0.0) return;
    e.translational += 0.5 * kind.mass * p.velocity[i].squaredNorm();
    e.rotational += rotational_energy(p.angular_momentum[i], p.angular_velocity[i]);
    e.potential -= kind.mass * scene.run.gravity.dot(p.position[i]);
}

}  // namespace

double mechanical_energy(const Particles& particles, const Scene& scene, std::uint32_t i) {
    Energies e;
    add_body(e, particles, scene, i);
    return e.translational + e.rotational + e.potential;
}

Energies energies(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    Energies e;
    e.dissipated = simulation.ledger().dissipated_before;
    e.wall_work = simulation.ledger().wall_work_before;
    e.removed = simulation.ledger().removed;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        add_body(e, p, simulation.scene(), i);
        e.dissipated += simulation.ledger().dissipated[i];
        e.wall_work += simulation.ledger().wall_work[i];
        // Every contact once: from its first particle, in the order of the adjacency, which does
        // not depend on when the lists were made.
        for (const Adjacency::Entry entry : simulation.lists().adjacency.of(i)) {
            if (entry.is_j == 0 && simulation.lists().touching[entry.result] != 0) {
                e.elastic += simulation.lists().results[entry.result].elastic_energy;
            }
        }
    }
    e.inserted = simulation.inserted_energy();
    return e;
}

}  // namespace dem::runtime
