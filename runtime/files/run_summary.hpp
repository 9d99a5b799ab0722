// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dem::runtime {

/// What went out through an outlet, or through a plane less what came back.
struct OutletSummary {
    std::string name;
    std::string kind;  ///< "remove", "flow"
    std::int64_t bodies = 0;
    double mass = 0.0;  ///< [kg]
};

/// What summary.json says about a finished run; SI.
struct RunSummary {
    std::string case_path;
    std::string end;     ///< "end_time", "at_rest", "interrupted", "failed"
    std::string reason;  ///< of an interruption or a failure, bodies without room among them
    std::uint64_t steps = 0;
    double time = 0.0;       ///< simulated [s]
    double time_step = 0.0;  ///< [s]
    std::uint64_t particles = 0;
    std::vector<std::pair<std::string, std::uint64_t>> missing;  ///< bodies never placed, by group
    std::vector<OutletSummary> outlets;
    std::uint64_t core_overlaps = 0;  ///< contacts in which cores of convex bodies overlapped
    double wall_time = 0.0;           ///< [s]
    double measure_time = 0.0;        ///< of the wall time for measures [s]
    double output_time = 0.0;         ///< of the wall time for files [s]
    double microseconds_per_particle_step = 0.0;  ///< the rest over all particle steps
    int threads = 1;                              ///< at most
    double threads_used = 1.0;                    ///< on average over the wall time of the steps
    int lanes = 1;                                ///< contacts computed at a time
    std::uint64_t seed = 0;
    std::uint64_t state_hash = 0;  ///< of the final state, written as 16 hex digits
    std::vector<std::pair<std::string, double>> measures;       ///< final values, by name
    std::vector<std::pair<std::string, std::uint64_t>> inputs;  ///< template, hash of its input
};

/// Writes summary.json, whole or not at all. A value that is not finite becomes null.
void write_summary(const std::filesystem::path& path, const RunSummary& summary);

/// Whether summary.json tells of the end, with its reason, and the state that `summary` has.
bool tells_of(const std::filesystem::path& path, const RunSummary& summary);

}  // namespace dem::runtime
