// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/frames.hpp"
#include "runtime/files/history_writer.hpp"
#include "runtime/output/cadence.hpp"
#include "runtime/output/wall_contacts.hpp"
#include "runtime/run.hpp"
#include "runtime/simulation.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace dem::runtime {

/// How far a run's outputs are: what a resumed run keeps of them. The state of a checkpoint itself
/// has not been sampled: the run that goes on does that, if it is due then.
struct OutputProgress {
    std::uint64_t frames = 0;
    std::uint64_t rows = 0;            ///< of history.csv
    std::uint64_t rows_hash = 0;       ///< of what they say
    double sampled = -1.0;             ///< what was due up to then is in the files [s]
    double frames_every = 0.0;         ///< [s]
    double history_every = 0.0;        ///< [s]
    double row_time = 0.0;             ///< of the last row [s]
    std::vector<Outflow> row_outflow;  ///< what it said, by outlet
    LoadsOfLastFrame loads;

    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("outputs.frames", self.frames);
        visit("outputs.rows", self.rows);
        visit("outputs.rows_hash", self.rows_hash);
        visit("outputs.sampled", self.sampled);
        visit("outputs.frames_every", self.frames_every);
        visit("outputs.history_every", self.history_every);
        visit("outputs.row_time", self.row_time);
        visit("outputs.row_outflow", self.row_outflow);
        LoadsOfLastFrame::visit_state(self.loads, visit);
    }
};

/// DIR/checkpoint.h5.
std::filesystem::path checkpoint_path(const Scene& scene);

/// Whether the folder of the scene holds all that a run leaves at this end.
bool holds_end(const Scene& scene, const RunResult& result);

/// What a run leaves in its folder (docs/output-files.md). Frames and rows are complete on disk as
/// soon as they are due; final.csv, final.png and summary.json appear at the end.
class Outputs {
  public:
    /// Removes what an earlier run left at its end and begins the other files in the folder, which
    /// must exist. Throws Error when that is impossible.
    explicit Outputs(const Scene& scene);

    /// Goes on with the files of the run that made a checkpoint: what they have more than
    /// `progress` says is dropped. Intervals that the case leaves open stay as they were, whatever
    /// its end time is now. Throws Error when the files have less or were changed.
    Outputs(const Scene& scene, const OutputProgress& progress);

    /// Writes what is due at the present time; call before each step.
    void sample(const Simulation& simulation);

    /// Whether the sample after the step that leads to `time` [s] will ask for contacts.
    bool will_ask_for_contacts(double time) const {
        return writes_contacts_ && frame_cadence_.will_be_due(time);
    }

    /// After the last sample that did not fail.
    const OutputProgress& progress() const { return progress_; }
    double measure_time() const { return measure_time_; }  ///< taken by measures so far [s]
    double output_time() const { return output_time_; }    ///< taken by frames and rows so far [s]

    /// Lets the disk take what has been written: a checkpoint must not outlive what it counts on.
    void sync();

    /// Writes the last state, due or not, with every measure: each file, whatever becomes of the
    /// others, before the first failure is thrown.
    void finish(const Simulation& simulation, const RunResult& result);

  private:
    void write_frame(const Simulation& simulation);
    void write_row(const Simulation& simulation);
    /// What went out until now, and per second since the last row; remembers both for the next.
    void add_outflow(const Simulation& simulation, std::vector<std::optional<double>>& row);
    void measure(const Simulation& simulation);
    void write_last_row(const Simulation& simulation);
    void write_end(const Simulation& simulation, const RunResult& result) const;

    std::filesystem::path directory_;
    bool writes_contacts_;
    WallTriangles wall_triangles_;
    HistoryWriter history_;
    FrameWriter frames_;
    OutputProgress progress_;
    Cadence frame_cadence_;
    Cadence row_cadence_;
    std::vector<Cadence> measure_cadences_;
    std::vector<std::uint8_t> due_measures_;  ///< which to compute now
    /// By measure, none where it was not due: what the next row says.
    std::vector<std::optional<double>> measured_;
    double last_frame_ = -1.0;  ///< [s]
    double last_row_ = -1.0;    ///< [s]
    double measure_time_ = 0.0;
    double output_time_ = 0.0;
};

}  // namespace dem::runtime
