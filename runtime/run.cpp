// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "common/attempts.hpp"
#include "common/error.hpp"
#include "common/format.hpp"
#include "common/signals.hpp"
#include "common/stopwatch.hpp"
#include "runtime/checkpoint/run_checkpoint.hpp"
#include "runtime/measure/at_rest.hpp"
#include "runtime/output/earlier_run.hpp"
#include "runtime/output/folder_lock.hpp"
#include "runtime/output/outputs.hpp"
#include "runtime/rewind.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace dem::runtime {

namespace {

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

/// What a run is made of while it lasts.
struct RunParts {
    std::unique_ptr<Simulation> simulation;
    AtRest& at_rest;
    Outputs& outputs;
    Rewind rewind;
    std::uint64_t good_steps;      ///< those that did not fail
    double checkpoint_time = 0.0;  ///< spent on checkpoints so far [s]
};

void require_no_results(const std::filesystem::path& folder) {
    const std::string results = earlier_results(folder);
    if (!results.empty()) throw Error(folder.string(), results);
}

void require_checkpoint(const Scene& scene) {
    const std::filesystem::path path = checkpoint_path(scene);
    if (std::filesystem::exists(path)) return;
    throw Error(path.string(), "not found, expected the checkpoint of a run to resume");
}

void make_checkpoint(RunParts& run) {
    const Stopwatch watch(run.checkpoint_time);
    run.outputs.sync();
    save_checkpoint(checkpoint_path(run.simulation->scene()), *run.simulation, run.at_rest,
                    run.outputs.progress());
}

void require_steps_to_go(const Simulation& simulation, std::uint64_t last_step) {
    if (simulation.steps() <= last_step) return;
    const Scene& scene = simulation.scene();
    throw Error(scene.case_path,
                format("end_time %g s is before the checkpoint at %g s, expected no earlier one",
                       scene.run.end_time, simulation.time()));
}

/// When a checkpoint is due by the clock: the first one soon, for a run that has just begun is lost
/// as easily as any other.
class CheckpointClock {
  public:
    explicit CheckpointClock(double every)
        : every_(every), next_(Progress::steady_seconds() + std::min(every, first)) {}

    bool is_due(double now) const { return now >= next_; }
    void restart() { next_ = Progress::steady_seconds() + every_; }

  private:
    static constexpr double first = 60.0;  // [s]
    double every_;
    double next_;
};

/// Why the run ends with the present state, if it does.
std::optional<RunResult::End> end_of_run(const Simulation& simulation, const AtRest& at_rest,
                                         const RunOptions& options, std::uint64_t last_step) {
    using End = RunResult::End;
    if (at_rest.was_reached() && simulation.scene().run.stop_at_rest) return End::at_rest;
    if (options.stop_signal != nullptr && *options.stop_signal != 0) return End::interrupted;
    if (simulation.steps() >= last_step) return End::end_time;
    return std::nullopt;
}

std::string reason_of(RunResult::End end, const AtRest& at_rest, const RunOptions& options) {
    if (end == RunResult::End::at_rest && at_rest.has_rocking()) return "bodies rock in place";
    if (end == RunResult::End::interrupted) return signal_name(*options.stop_signal);
    return "";
}

/// Whether frames can have the contacts of the present state if they are asked for.
bool knows_contacts(const Simulation& simulation) {
    return !simulation.scene().output.contacts || simulation.contacts() != nullptr;
}

/// Keeps the present state where that is due: on disk, and in memory for the way back. A state that
/// does not know its contacts is not kept, for it may become the last. Returns whether the next one
/// is wanted for that.
bool keep_state(RunParts& run, CheckpointClock& checkpoints) {
    const double now = Progress::steady_seconds();
    const bool is_checkpoint_due = checkpoints.is_due(now);
    if (!is_checkpoint_due && !run.rewind.is_due(now)) return false;
    if (!knows_contacts(*run.simulation)) return true;
    if (is_checkpoint_due) {
        make_checkpoint(run);
        checkpoints.restart();
    }
    if (run.rewind.is_due(now)) run.rewind.keep(*run.simulation, now);
    return false;
}

/// Steps until something ends the run. The last state is left to Outputs::finish.
void run_steps(RunParts& run, const RunOptions& options, std::uint64_t last_step,
               RunResult& result) {
    Simulation& simulation = *run.simulation;
    const Stopwatch watch(result.wall_time);
    const bool stop_at_rest = simulation.scene().run.stop_at_rest;
    CheckpointClock checkpoints(simulation.scene().output.checkpoint_every);
    std::optional<RunResult::End> end;
    while (!(end = end_of_run(simulation, run.at_rest, options, last_step))) {
        const bool wants_next = keep_state(run, checkpoints);
        run.outputs.sample(simulation);
        const std::uint64_t next = simulation.steps() + 1;
        const bool is_shown =
            run.outputs.will_ask_for_contacts(static_cast<double>(next) * simulation.time_step());
        simulation.step(wants_next || is_shown || next == last_step);
        ++run.good_steps;
        if (stop_at_rest)
            run.at_rest.look(simulation.bodies(), simulation.time(), simulation.is_inserted());
        result.particle_steps += simulation.particles().size();
        report(options, simulation);
    }
    result.end = *end;
    result.reason = reason_of(*end, run.at_rest, options);
}

/// Steps until something ends the run. What fails is returned, and a step that failed taken back.
std::exception_ptr run_to_end(RunParts& run, const RunOptions& options, std::uint64_t last_step,
                              RunResult& result) {
    try {
        run_steps(run, options, last_step, result);
        if (!knows_contacts(*run.simulation))
            run.simulation = run.rewind.back_to(run.good_steps, *run.simulation);
        return nullptr;
    } catch (const std::exception& error) {
        result.end = RunResult::End::failed;
        result.reason = error.what();
        std::exception_ptr failure = std::current_exception();
        if (run.simulation->steps() != run.good_steps) {
            run.simulation = run.rewind.back_to(run.good_steps, *run.simulation);
        }
        return failure;
    }
}

std::uint64_t removed_bodies(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    return p.next_id - p.size();  // ids are never given twice
}

/// The last state. A run that came to its end without some of its bodies has failed.
void describe_state(const Simulation& simulation, RunResult& result) {
    result.steps = simulation.steps();
    result.particles = simulation.particles().size();
    result.removed = removed_bodies(simulation);
    result.time = simulation.time();
    result.time_step = simulation.time_step();
    result.settled = simulation.walls().settled;
    result.has_waiting_motion = simulation.has_waiting_motion();
    result.core_overlaps = simulation.core_overlaps();
    result.state_hash = simulation.state_hash();
    result.missing = missing_bodies(simulation);
    if (result.end != RunResult::End::end_time && result.end != RunResult::End::at_rest) return;
    std::string crowded;
    for (const MissingBodies& group : result.missing) {
        if (group.crowded_out > 0) crowded += (crowded.empty() ? "" : "; ") + crowding(group);
    }
    if (crowded.empty()) return;
    result.end = RunResult::End::failed;
    result.reason = crowded;
}

void describe_times(const RunParts& run, RunResult& result) {
    result.measure_time = run.outputs.measure_time();
    result.output_time = run.outputs.output_time() + run.checkpoint_time;
    if (result.particle_steps == 0) return;
    const double step_time = result.wall_time - result.measure_time - result.output_time;
    result.microseconds_per_particle_step =
        1e6 * step_time / static_cast<double>(result.particle_steps);
}

/// The result of a resumed run that has nothing left to do, if its files say so, too.
std::optional<RunResult> finished_run(const Simulation& simulation, const AtRest& at_rest,
                                      const RunOptions& options, std::uint64_t last_step) {
    const auto end = end_of_run(simulation, at_rest, options, last_step);
    if (!end || *end == RunResult::End::interrupted) return std::nullopt;
    RunResult result;
    result.end = *end;
    result.reason = reason_of(*end, at_rest, options);
    describe_state(simulation, result);
    if (!holds_end(simulation.scene(), result)) return std::nullopt;
    result.was_finished = true;
    return result;
}

}  // namespace

std::string crowding(const MissingBodies& group) {
    return group.where + ": [particles." + group.group + "]: " + std::to_string(group.placed) +
           " of " + std::to_string(group.count) + " bodies were placed, " +
           std::to_string(group.crowded_out) +
           " more found their region occupied when they were due, expected a larger region or "
           "longer times between the batches";
}

double check_resume(Scene scene) {
    require_checkpoint(scene);
    const double dt = time_step(scene).value;
    Simulation simulation(std::move(scene), dt);
    AtRest at_rest(simulation.scene());
    load_checkpoint(checkpoint_path(simulation.scene()), simulation, at_rest);
    return simulation.time();
}

RunResult run(Scene scene, const RunOptions& options) {
    const double dt = time_step(scene).value;
    const std::uint64_t last_step = step_count(scene.run, dt, scene.case_path);
    const std::filesystem::path folder = scene.output.directory;
    if (options.resume && !std::filesystem::is_directory(folder)) require_checkpoint(scene);
    const FolderLock lock(folder);
    if (options.resume) {
        // A run that was killed before its first checkpoint cannot go on, but keeps its frames.
        if (!std::filesystem::exists(checkpoint_path(scene))) mend_frames(folder);
        require_checkpoint(scene);
    } else {
        if (!options.force) require_no_results(folder);
        require_files(folder);
    }
    remove_remains(folder);
    auto simulation = std::make_unique<Simulation>(std::move(scene), dt);
    AtRest at_rest(simulation->scene());
    std::optional<OutputProgress> progress;
    if (options.resume) {
        progress = load_checkpoint(checkpoint_path(simulation->scene()), *simulation, at_rest);
        require_steps_to_go(*simulation, last_step);
        const auto finished = finished_run(*simulation, at_rest, options, last_step);
        if (finished) return *finished;
    }
    Outputs outputs =
        progress ? Outputs(simulation->scene(), *progress) : Outputs(simulation->scene());
    if (options.progress != nullptr) options.progress->begin_at(simulation->time());

    RunResult result;
    Rewind rewind(*simulation, Progress::steady_seconds());
    const std::uint64_t steps = simulation->steps();
    RunParts parts{std::move(simulation), at_rest, outputs, std::move(rewind), steps};
    const std::exception_ptr failure = run_to_end(parts, options, last_step, result);
    describe_state(*parts.simulation, result);
    describe_times(parts, result);
    Attempts last;
    if (failure) last.make([&] { std::rethrow_exception(failure); });
    last.make([&] { make_checkpoint(parts); });
    last.make([&] { outputs.finish(*parts.simulation, result); });
    last.check();
    return result;
}

}  // namespace dem::runtime
