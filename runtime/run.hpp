// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/progress.hpp"
#include "runtime/scene.hpp"

#include <csignal>
#include <cstdint>
#include <string>
#include <vector>

namespace dem::runtime {

struct RunOptions {
    Progress* progress = nullptr;  ///< updated with the simulated time, out of Scene::run.end_time
    /// Set to its number by a signal handler: the run ends after the current step and keeps
    /// everything.
    const volatile std::sig_atomic_t* stop_signal = nullptr;
    bool resume = false;  ///< go on from the checkpoint in Scene::output.directory
    bool force = false;   ///< else begin there only where no results of another run are
};

/// A group of which not every body came in.
struct MissingBodies {
    std::string group;
    std::string where;              ///< "case.ini:31", for messages
    std::uint64_t count = 0;        ///< bodies of the group
    std::uint64_t placed = 0;       ///< so many of them came in
    std::uint64_t crowded_out = 0;  ///< were due and found no room; the others were not due yet
};

/// One line about bodies of a group that found no room.
std::string crowding(const MissingBodies& group);

struct RunResult {
    enum class End : std::uint8_t { end_time, at_rest, interrupted, failed };
    End end = End::end_time;    ///< failed, too, where bodies found no room
    std::string reason;         ///< "SIGTERM" of an interruption, the message of a failure, ...
    bool was_finished = false;  ///< a resumed run was: nothing was computed, no file touched
    std::uint64_t steps = 0;
    std::uint32_t particles = 0;
    std::uint64_t removed = 0;  ///< particles that outlets, or the end of the domain, took out
    std::uint64_t particle_steps = 0;             ///< particles, summed over the steps
    double time = 0.0;                            ///< simulated [s]
    double time_step = 0.0;                       ///< [s]
    double settled = infinite;                    ///< when motions began that wait for it [s]
    bool has_waiting_motion = false;              ///< one that waits still
    double wall_time = 0.0;                       ///< of the time loop [s]
    double measure_time = 0.0;                    ///< of that for measures [s]
    double output_time = 0.0;                     ///< of that for frames, rows, checkpoints [s]
    double microseconds_per_particle_step = 0.0;  ///< the rest over all particle steps
    std::uint64_t core_overlaps = 0;              ///< simulation.hpp, Simulation::core_overlaps
    std::uint64_t state_hash = 0;                 ///< simulation.hpp, Simulation::state_hash
    std::vector<MissingBodies> missing;           ///< in the order of the case
};

/// Runs a scene from time 0, or from its checkpoint, to its end and writes frames.h5 and
/// frames.xdmf, history.csv, final.csv, summary.json and checkpoint.h5 into Scene::output.directory
/// (created when missing). A resumed run gives the bits of one that was never interrupted; of one
/// that is finished every file stays as it is.
/// Throws Error for a time step above the critical one, a folder that cannot be written, is written
/// by another run or holds results, a checkpoint that is none of this case, and a run that fails
/// (a body leaves, overlaps too much, a number is not finite, a disk is full): then with step, time
/// and ids, after the last good state has been written as at any other end.
RunResult run(Scene scene, const RunOptions& options);

/// Throws Error unless a run of this scene could be resumed from its checkpoint, whose time it
/// returns [s]. Writes nothing.
double check_resume(Scene scene);

}  // namespace dem::runtime
