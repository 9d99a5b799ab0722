// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/frames.hpp"
#include "formats/history_writer.hpp"
#include "runtime/output/cadence.hpp"
#include "runtime/run.hpp"
#include "runtime/simulation.hpp"

#include <filesystem>
#include <vector>

namespace dem {

/// How far a run's outputs are: what a resumed run keeps of them.
struct OutputProgress {
    std::uint64_t frames = 0;
    std::uint64_t rows = 0;    ///< of history.csv
    double last_frame = -1.0;  ///< [s]
    double last_row = -1.0;    ///< [s]
};

/// DIR/checkpoint.h5.
std::filesystem::path checkpoint_path(const Scene& scene);

/// What a run leaves in its folder (docs/output-files.md). Frames and rows are complete on disk as
/// soon as they are due; final.csv, final.png and summary.json appear at the end.
class Outputs {
  public:
    /// Removes what an earlier run left at its end and begins the other files in the folder, which
    /// must exist. Throws Error when that is impossible.
    explicit Outputs(const Scene& scene);

    /// Goes on with the files of the run that made a checkpoint at `time` [s]: what they have more
    /// than `progress` says is dropped. Throws Error when they have less.
    Outputs(const Scene& scene, const OutputProgress& progress, double time);

    /// Writes what is due at the present time; call before the first step and after each.
    void sample(const Simulation& simulation);

    const OutputProgress& progress() const { return progress_; }

    /// Lets the disk take what has been written: a checkpoint must not outlive what it counts on.
    void sync() const;

    /// Writes the last state.
    void finish(const Simulation& simulation, const RunResult& result);

  private:
    void make_cadences(const Scene& scene);
    void write_frame(const Simulation& simulation);
    void write_history(const Simulation& simulation);

    std::filesystem::path directory_;
    HistoryWriter history_;
    FrameWriter frames_;
    Cadence frame_cadence_;
    std::vector<Cadence> history_cadences_;  ///< of the history and of every measure
    OutputProgress progress_;
};

}  // namespace dem
