// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/rewind.hpp"

#include "common/progress.hpp"
#include "runtime/checkpoint/state_archive.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

constexpr double shortest_interval = 1.0;  // [s]: so long may it take to go the way again
constexpr double largest_cost = 0.005;     // of the time, for keeping states

/// A velocity that is no number is found a step later, when it has spoiled a position.
bool is_finite(const Simulation& simulation) {
    const auto all = [](const std::vector<Vec3>& vectors) {
        return std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
    };
    const Particles& p = simulation.particles();
    return all(p.velocity) && all(p.angular_momentum) && all(p.angular_velocity);
}

}  // namespace

void Rewind::keep(const Simulation& simulation, double now) {
    if (!state_.empty() && !is_finite(simulation)) return;
    StateWriter writer;
    simulation.save(writer);
    state_ = writer.take();
    const double cost = Progress::steady_seconds() - now;
    next_ = now + std::max(shortest_interval, cost / largest_cost);
}

std::unique_ptr<Simulation> Rewind::back_to(std::uint64_t steps, const Simulation& failed) const {
    auto simulation = std::make_unique<Simulation>(failed.scene(), failed.time_step());
    StateReader reader(state_, "memory");
    simulation->load(reader);
    reader.finish();
    while (simulation->steps() < steps) {
        simulation->step(simulation->steps() + 1 == steps);
        if (!is_finite(*simulation)) return back_to(simulation->steps() - 1, failed);
    }
    return simulation;
}

}  // namespace dem::runtime
