// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/step_team.hpp"

#include "common/threads/available_cores.hpp"

#include <algorithm>
#include <utility>

namespace dem {

namespace {

/// More threads than cores never help.
int most_threads(int most, const std::vector<int>& forced) {
    if (!forced.empty()) return *std::max_element(forced.begin(), forced.end());
    const int cores = available_cores();
    return most > 0 ? std::min(most, cores) : cores;
}

}  // namespace

StepTeam::StepTeam(int most, std::vector<int> forced)
    : team_(most_threads(most, forced)), size_(team_.most()), forced_(std::move(forced)) {
    if (!forced_.empty()) team_.share_everything();
}

double StepTeam::mean_size() const {
    return time_ > 0.0 ? thread_time_ / time_ : 1.0;
}

void StepTeam::begin_step() {
    threads_ = forced_.empty() ? size_.next() : forced_[steps_ % forced_.size()];
    team_.use(threads_);
    rare_ = {};
    began_ = Clock::now();
}

void StepTeam::end_step() {
    const double seconds = std::chrono::duration<double>(Clock::now() - began_ - rare_).count();
    size_.step_took(seconds);
    time_ += seconds;
    thread_time_ += threads_ * seconds;
    ++steps_;
}

StepTeam::Step::Step(StepTeam& steps) : steps_(steps), in_force_(&steps.team_) {
    steps_.begin_step();
}

StepTeam::Step::~Step() {
    steps_.end_step();
}

StepTeam::RarePart::RarePart(StepTeam& steps) : steps_(steps), began_(Clock::now()) {}

StepTeam::RarePart::~RarePart() {
    steps_.rare_ += Clock::now() - began_;
}

}  // namespace dem
