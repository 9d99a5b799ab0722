// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/force_sum.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/loop_grain.hpp"

namespace dem::runtime {

void sum_forces(Particles& particles, NeighborLists& lists, const Scene& scene,
                EnergyLedger& ledger) {
    particles.force.swap(particles.old_force);
    particles.torque.swap(particles.old_torque);
    share_each(particles.size(), bodies_at_a_time, [&](std::size_t k) {
        const auto i = static_cast<std::uint32_t>(k);
        Vec3 force = Vec3::Zero();
        Vec3 torque = Vec3::Zero();
        double dissipated = 0.0;
        double wall_work = 0.0;
        for (const Adjacency::Entry entry :
             lists.touching_entries.of(i, lists.adjacency, lists.touching)) {
            const PairResult& pair = lists.results[entry.result];
            if (entry.is_j != 0) {
                force -= Vec3(pair.force);
                torque += Vec3(pair.torque_j);
            } else {
                force += Vec3(pair.force);
                torque += Vec3(pair.torque_i);
                dissipated += pair.dissipated_energy;
                wall_work += pair.wall_work;
            }
        }
        particles.force[i] = force + scene.kinds[particles.kind[i]].mass * scene.run.gravity;
        particles.torque[i] = torque;
        ledger.dissipated[i] += dissipated;
        ledger.wall_work[i] += wall_work;
    });
}

}  // namespace dem::runtime
