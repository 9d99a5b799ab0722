// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "common/error.hpp"
#include "common/stopwatch.hpp"
#include "runtime/checkpoint/run_checkpoint.hpp"
#include "runtime/measure/at_rest.hpp"
#include "runtime/output/folder_lock.hpp"
#include "runtime/output/outputs.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace dem {

namespace {

using Clock = std::chrono::steady_clock;

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

struct RunParts {
    Simulation& simulation;
    AtRest& at_rest;
    Outputs& outputs;
    double& checkpoint_time;  ///< spent on checkpoints so far [s]
};

void require_checkpoint(const Scene& scene) {
    const std::filesystem::path path = checkpoint_path(scene);
    if (std::filesystem::exists(path)) return;
    throw Error(path.string(), "not found, expected the checkpoint of a run to resume");
}

Outputs begun_outputs(bool resume, Simulation& simulation, AtRest& at_rest) {
    const Scene& scene = simulation.scene();
    if (!resume) return Outputs(scene);
    const OutputProgress progress = load_checkpoint(checkpoint_path(scene), simulation, at_rest);
    return {scene, progress};
}

void make_checkpoint(const RunParts& run) {
    const Stopwatch watch(run.checkpoint_time);
    run.outputs.sync();
    save_checkpoint(checkpoint_path(run.simulation.scene()), run.simulation, run.at_rest,
                    run.outputs.progress());
}

/// Why the run ends with the present state, if it does.
std::optional<RunResult::End> end_of_run(const RunParts& run, const RunOptions& options,
                                         std::uint64_t last_step) {
    using End = RunResult::End;
    if (run.at_rest.was_reached() && run.simulation.scene().run.stop_at_rest) return End::at_rest;
    if (is_interrupted(options)) return End::interrupted;
    if (run.simulation.steps() >= last_step) return End::end_time;
    return std::nullopt;
}

/// Steps until something ends the run; returns the sum of particles over the steps. The last state
/// is left to Outputs::finish.
std::uint64_t run_steps(const RunParts& run, const RunOptions& options, std::uint64_t last_step,
                        RunResult::End& end) {
    Simulation& simulation = run.simulation;
    const bool stop_at_rest = simulation.scene().run.stop_at_rest;
    const std::chrono::duration<double> checkpoint_every(
        simulation.scene().output.checkpoint_every);
    auto last_checkpoint = Clock::now();
    std::uint64_t particle_steps = 0;
    std::optional<RunResult::End> reason;
    while (!(reason = end_of_run(run, options, last_step))) {
        if (Clock::now() - last_checkpoint >= checkpoint_every) {
            make_checkpoint(run);
            last_checkpoint = Clock::now();
        }
        run.outputs.sample(simulation);
        simulation.step();
        if (stop_at_rest) run.at_rest.look(simulation);
        particle_steps += simulation.particles().size();
        report(options, simulation);
    }
    end = *reason;
    return particle_steps;
}

}  // namespace

void check_resume(Scene scene) {
    require_checkpoint(scene);
    const double dt = time_step(scene).value;
    Simulation simulation(std::move(scene), dt);
    AtRest at_rest(simulation.scene());
    load_checkpoint(checkpoint_path(simulation.scene()), simulation, at_rest);
}

RunResult run(Scene scene, const RunOptions& options) {
    const double dt = time_step(scene).value;
    const std::uint64_t last_step = step_count(scene.run, dt, scene.case_path);
    if (options.resume) require_checkpoint(scene);
    const FolderLock lock(scene.output.directory);
    Simulation simulation(std::move(scene), dt);
    AtRest at_rest(simulation.scene());
    Outputs outputs = begun_outputs(options.resume, simulation, at_rest);
    if (options.progress != nullptr) options.progress->begin_at(simulation.time());

    RunResult result;
    std::uint64_t particle_steps = 0;
    double checkpoint_time = 0.0;
    const RunParts parts{simulation, at_rest, outputs, checkpoint_time};
    {
        const Stopwatch watch(result.wall_time);
        particle_steps = run_steps(parts, options, last_step, result.end);
    }
    result.measure_time = outputs.measure_time();
    result.output_time = outputs.output_time() + checkpoint_time;
    make_checkpoint(parts);
    result.steps = simulation.steps();
    result.particles = simulation.particles().size();
    result.time = simulation.time();
    result.time_step = dt;
    if (particle_steps > 0) {
        const double step_time = result.wall_time - result.measure_time - result.output_time;
        result.microseconds_per_particle_step =
            1e6 * step_time / static_cast<double>(particle_steps);
    }
    result.core_overlaps = simulation.core_overlaps();
    result.state_hash = simulation.state_hash();
    result.missing = missing_bodies(simulation);
    outputs.finish(simulation, result);
    return result;
}

}  // namespace dem
