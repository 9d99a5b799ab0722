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

/// What a run leaves in its folder (docs/output-files.md). Frames and rows are complete on disk as
/// soon as they are due; final.csv, final.png and summary.json appear at the end.
class Outputs {
  public:
    /// Makes the folder when it is missing, removes an earlier run's final.csv and summary.json and
    /// begins the other files. Throws Error when that is impossible.
    explicit Outputs(const Scene& scene);

    /// Writes what is due at the present time; call before the first step and after each.
    void sample(const Simulation& simulation);

    /// Writes the last state.
    void finish(const Simulation& simulation, const RunResult& result);

  private:
    void write_frame(const Simulation& simulation);
    void write_history(const Simulation& simulation);

    std::filesystem::path directory_;
    FrameWriter frames_;
    HistoryWriter history_;
    Cadence frame_cadence_;
    std::vector<Cadence> history_cadences_;  ///< of the history and of every measure
    double last_frame_ = -1.0;               ///< [s]
    double last_row_ = -1.0;                 ///< [s]
};

}  // namespace dem
