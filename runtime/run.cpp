// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "runtime/measure/at_rest.hpp"
#include "runtime/output/outputs.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <omp.h>

namespace dem {

namespace {

bool is_interrupted(const RunOptions& options) {
    return options.stop_requested != nullptr && *options.stop_requested != 0;
}

void report(const RunOptions& options, const Simulation& simulation) {
    if (options.progress == nullptr || !options.progress->is_due(simulation.time())) return;
    options.progress->update(simulation.time(),
                             std::to_string(simulation.particles().size()) + " particles");
}

std::vector<MissingBodies> missing_bodies(const Simulation& simulation) {
    const Inserter& inserter = simulation.inserter();
    std::vector<MissingBodies> result;
    for (std::uint32_t g = 0; g < simulation.scene().insertions.size(); ++g) {
        const std::uint64_t missing = inserter.missing(g);
        if (missing == 0) continue;
        const InsertionGroup& group = simulation.scene().insertions[g];
        const std::uint64_t count =
            group.mode == InsertionGroup::Mode::file ? group.placements.size() : group.count;
        result.push_back(
            {group.name, group.where, count, count - missing, inserter.crowded_out(g)});
    }
    return result;
}

}  // namespace

RunResult run(Scene scene, const RunOptions& options) {
    omp_set_num_threads(scene.run.threads > 0 ? scene.run.threads : omp_get_num_procs());
    const double dt = time_step(scene).value;
    // The last step reaches the end time but for rounding.
    const auto last_step = static_cast<std::uint64_t>(std::ceil(scene.run.end_time / dt - 1e-6));
    Outputs outputs(scene);
    Simulation simulation(std::move(scene), dt);
    AtRest at_rest(simulation.scene());
    outputs.sample(simulation);

    RunResult result;
    std::uint64_t particle_steps = 0;
    const auto start = std::chrono::steady_clock::now();
    while (simulation.steps() < last_step) {
        simulation.step();
        outputs.sample(simulation);
        report(options, simulation);
        particle_steps += simulation.particles().size();
        if (is_interrupted(options)) {
            result.end = RunResult::End::interrupted;
            break;
        }
        if (simulation.scene().run.stop_at_rest && at_rest.reached(simulation)) {
            result.end = RunResult::End::at_rest;
            break;
        }
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    result.steps = simulation.steps();
    result.particles = simulation.particles().size();
    result.time = simulation.time();
    result.time_step = dt;
    result.wall_time = elapsed.count();
    if (particle_steps > 0) {
        result.microseconds_per_particle_step =
            1e6 * elapsed.count() / static_cast<double>(particle_steps);
    }
    result.state_hash = simulation.state_hash();
    result.missing = missing_bodies(simulation);
    outputs.finish(simulation, result);
    return result;
}

}  // namespace dem
