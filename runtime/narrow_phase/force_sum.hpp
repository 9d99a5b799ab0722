// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/narrow_phase/neighbor_lists.hpp"

#include <vector>

namespace dem::runtime {

/// What each particle has lost and been given since it was inserted, a pair's share booked on its
/// first particle, so that sums do not depend on threads [J].
struct EnergyLedger {
    std::vector<double> dissipated;  ///< by dashpots, slip, and contacts that ended stretched
    std::vector<double> wall_work;   ///< done on it by moving walls
    // The same of bodies that were taken out, and what they took along with their contacts.
    double dissipated_before = 0.0;
    double wall_work_before = 0.0;
    double removed = 0.0;

    void resize(std::size_t particles) {
        dissipated.resize(particles, 0.0);
        wall_work.resize(particles, 0.0);
    }
    /// Bodies that are marked leave; what was booked on them goes on in the sums before.
    void remove(std::span<const std::uint8_t> leaving);
};

/// Force and torque on every particle: its contacts in the order of the adjacency, then its weight.
/// What they were goes to old_force and old_torque.
void sum_forces(Particles& particles, NeighborLists& lists, const Scene& scene,
                EnergyLedger& ledger);

/// Force and torque anew after contacts have left the lists: what was computed for the others is
/// summed, and nothing booked.
void sum_remaining_forces(Particles& particles, NeighborLists& lists, const Scene& scene);

/// Books what contacts that ended had still stored.
inline void book(std::span<const Parting> partings, EnergyLedger& ledger) {
    for (const Parting& parting : partings) ledger.dissipated[parting.particle] += parting.lost;
}

}  // namespace dem::runtime
