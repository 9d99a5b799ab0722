// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace dem {

/// Called with the part of the work that is done, 0 to 1, and what comes next.
using StageProgress = std::function<void(double done, std::string_view next)>;

/// Says how far long work is and when it will probably end. On a terminal one line is redrawn a few
/// times a second; otherwise a line is printed at every tenth and at least every minute; quiet
/// prints nothing. Made by `main`, which chooses the stream.
class Progress {
  public:
    enum class Style { quiet, lines, terminal };
    using Clock = std::function<double()>;  ///< [s], never going back

    /// terminal when stderr is one.
    static Style stderr_style(bool is_quiet);

    /// `total`: the amount of work in any unit (steps, seconds of simulated time, files).
    Progress(std::ostream& out, Style style, std::string task, double total,
             Clock clock = steady_seconds);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Cheap to call often. `done` counts from 0 to total; `note` follows the estimate ("150
    /// particles").
    void update(double done, std::string_view note = {});

    /// Work that was done before this one began: no part of the rate.
    void begin_at(double done);

    /// For work of stages that differ: says no longer when it will probably end.
    void leave_out_estimate() { has_estimate_ = false; }

    /// True when update() would print; for callers whose note costs something to make.
    bool is_due(double done) const;

    /// A last line with the time taken. Without it the destructor only ends the terminal's line.
    void finish(std::string_view note = {});

    static double steady_seconds();

  private:
    struct Sample {
        double time, done;
    };
    double remaining_seconds(double now, double done);
    void print(const std::string& line, bool is_last);

    std::ostream& out_;
    Style style_;
    std::string task_;
    double total_;
    Clock clock_;
    double start_;
    double last_print_;
    int tenths_printed_ = 0;
    std::size_t width_printed_ = 0;
    bool line_is_open_ = false;
    bool has_estimate_ = true;
    // The rate is taken over the last 10 to 20 seconds: a packing that fills slows down all the
    // time, and an average since the start would promise too much.
    Sample older_, newer_;
};

/// "4 s", "3 min 20 s", "2 h 05 min".
std::string format_duration(double seconds);

}  // namespace dem
