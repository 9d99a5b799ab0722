// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/force_sum.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/compact.hpp"
#include "runtime/loop_grain.hpp"

namespace dem::runtime {

void EnergyLedger::remove(std::span<const std::uint8_t> leaving) {
    for (std::size_t i = 0; i < leaving.size(); ++i) {
        if (leaving[i] == 0) continue;
        dissipated_before += dissipated[i];
        wall_work_before += wall_work[i];
    }
    compact(dissipated, leaving);
    compact(wall_work, leaving);
}

namespace {

/// Of all contacts of a particle, in the order of the adjacency.
struct ContactSum {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    double dissipated = 0.0;  ///< [J]
    double wall_work = 0.0;   ///< [J]
};

ContactSum contact_sum(NeighborLists& lists, std::uint32_t i) {
    ContactSum sum;
    for (const Adjacency::Entry entry :
         lists.touching_entries.of(i, lists.adjacency, lists.touching)) {
        const PairResult& pair = lists.results[entry.result];
        if (entry.is_j != 0) {
            sum.force -= Vec3(pair.force);
            sum.torque += Vec3(pair.torque_j);
        } else {
            sum.force += Vec3(pair.force);
            sum.torque += Vec3(pair.torque_i);
            sum.dissipated += pair.dissipated_energy;
            sum.wall_work += pair.wall_work;
        }
    }
    return sum;
}

ContactSum set_force(Particles& particles, NeighborLists& lists, const Scene& scene,
                     std::uint32_t i) {
    ContactSum sum = contact_sum(lists, i);
    particles.force[i] = sum.force + scene.kinds[particles.kind[i]].mass * scene.run.gravity;
    particles.torque[i] = sum.torque;
    return sum;
}

}  // namespace

void sum_forces(Particles& particles, NeighborLists& lists, const Scene& scene,
                EnergyLedger& ledger) {
    particles.force.swap(particles.old_force);
    particles.torque.swap(particles.old_torque);
    share_each(particles.size(), bodies_at_a_time, [&](std::size_t k) {
        const auto i = static_cast<std::uint32_t>(k);
        const ContactSum sum = set_force(particles, lists, scene, i);
        ledger.dissipated[i] += sum.dissipated;
        ledger.wall_work[i] += sum.wall_work;
    });
}

void sum_remaining_forces(Particles& particles, NeighborLists& lists, const Scene& scene) {
    share_each(particles.size(), bodies_at_a_time, [&](std::size_t k) {
        set_force(particles, lists, scene, static_cast<std::uint32_t>(k));
    });
}

}  // namespace dem::runtime
