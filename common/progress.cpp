// SPDX-License-Identifier: BSD-3-Clause
#include "common/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>

#include <unistd.h>

namespace dem {

namespace {
constexpr double terminal_interval = 0.2;  // [s]: moves visibly, costs nothing
constexpr double line_interval = 60.0;     // [s]: a log file shows that the run is alive
constexpr double rate_window = 10.0;       // [s]
}  // namespace

std::string format_duration(double seconds) {
    char text[64];
    const auto whole = static_cast<long long>(std::llround(std::clamp(seconds, 0.0, 1e15)));
    if (whole < 60) {
        std::snprintf(text, sizeof text, "%lld s", whole);
    } else if (whole < 3600) {
        std::snprintf(text, sizeof text, "%lld min %02lld s", whole / 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%lld h %02lld min", whole / 3600, whole % 3600 / 60);
    }
    return text;
}

double Progress::steady_seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

Progress::Style Progress::stderr_style(bool is_quiet) {
    if (is_quiet) return Style::quiet;
    return isatty(STDERR_FILENO) != 0 ? Style::terminal : Style::lines;
}

Progress::Progress(std::ostream& out, Style style, std::string task, double total, Clock clock)
    : out_(out),
      style_(style),
      task_(std::move(task)),
      total_(total),
      clock_(std::move(clock)),
      start_(clock_()),
      last_print_(start_),
      older_{start_, 0.0},
      newer_(older_) {}

Progress::~Progress() {
    if (line_is_open_) out_ << std::endl;
}

void Progress::begin_at(double done) {
    older_ = {clock_(), done};
    newer_ = older_;
    // A rate of the first step alone would be none: the first line comes like the next.
    last_print_ = older_.time;
    if (total_ > 0.0) tenths_printed_ = static_cast<int>(10.0 * done / total_);
}

bool Progress::is_due(double done) const {
    if (style_ == Style::quiet) return false;
    const double waited = clock_() - last_print_;
    if (style_ == Style::terminal) return waited >= terminal_interval;
    return waited >= line_interval ||
           (total_ > 0.0 && static_cast<int>(10.0 * done / total_) > tenths_printed_);
}

double Progress::remaining_seconds(double now, double done) {
    if (now - newer_.time >= rate_window) {
        older_ = newer_;
        newer_ = {now, done};
    }
    const double gained = done - older_.done;
    return gained > 0.0 ? (now - older_.time) * (total_ - done) / gained : -1.0;
}

void Progress::update(double done, std::string_view note) {
    if (!is_due(done)) return;
    const double now = clock_();
    const double fraction = total_ > 0.0 ? std::clamp(done / total_, 0.0, 1.0) : 0.0;
    char percent[16];
    std::snprintf(percent, sizeof percent, "%5.1f %%", 100.0 * fraction);
    std::string line = task_ + " " + percent + ", " + format_duration(now - start_);
    const double remaining = remaining_seconds(now, done);
    if (has_estimate_ && remaining >= 0.0)
        line += ", about " + format_duration(remaining) + " left";
    if (!note.empty()) line.append(", ").append(note);
    print(line, false);
    last_print_ = now;
    tenths_printed_ = std::max(tenths_printed_, static_cast<int>(10.0 * fraction));
}

void Progress::finish(std::string_view note) {
    if (style_ == Style::quiet) return;
    std::string line = task_ + " done in " + format_duration(clock_() - start_);
    if (!note.empty()) line.append(", ").append(note);
    print(line, true);
}

void Progress::print(const std::string& line, bool is_last) {
    if (style_ == Style::lines) {
        out_ << line << std::endl;
        return;
    }
    // Blanks wipe out what a longer line left behind.
    const std::size_t blanks = width_printed_ > line.size() ? width_printed_ - line.size() : 0;
    out_ << '\r' << line << std::string(blanks, ' ');
    if (is_last) out_ << '\n';
    out_.flush();
    width_printed_ = line.size();
    line_is_open_ = !is_last;
}

}  // namespace dem
