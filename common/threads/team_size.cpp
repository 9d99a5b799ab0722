// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/team_size.hpp"

#include <algorithm>

namespace dem {

namespace {

/// Several time slices of a scheduler (3 to 4 ms): shorter blocks would be compared by whether a
/// neighbor happened to come in one of them [s].
constexpr double block_time = 20e-3;
/// Between trials, so that each way is tried twice a second [s].
constexpr double trial_interval = 0.25;
/// Share of the time that trials may cost.
constexpr double trial_share = 0.03;
/// A larger team has to make steps this much shorter, a smaller one is kept when it is about as
/// fast: between the two nothing changes, and cores are left to others.
constexpr double larger_wins_below = 0.93;
constexpr double smaller_wins_below = 1.02;
/// Beside busy neighbors a thread has a core of its own for some tens of milliseconds and shares
/// one for the next, so a larger team also wins by chance: a wrong one costs half a step until the
/// next trials, a right one that comes a moment later next to nothing.
constexpr int larger_wins_to_be_kept = 3;
constexpr int smaller_wins_to_be_kept = 2;
/// A trial that is this much slower is cut off after a quarter of a block.
constexpr double cut_off = 1.3;

}  // namespace

TeamSize::TeamSize(int most) {
    for (int size = 1; size < most; size *= 2) {
        sizes_.push_back(size);
        if (size >= 2 && 3 * size / 2 < most) sizes_.push_back(3 * size / 2);
    }
    sizes_.push_back(most);
}

bool TeamSize::can_go(Way way) const {
    return way == Way::larger ? kept_ + 1 < sizes_.size() : kept_ > 0;
}

void TeamSize::step_took(double seconds) {
    if (sizes_.size() == 1) return;
    block_.time += seconds;
    block_.steps += 1.0;
    if (is_trying_) {
        look_at_trial();
    } else {
        until_trial_ -= seconds;
        if (block_.time >= block_time) end_block();
    }
}

/// Ends a block of steps with the present size, which is what trials are compared with.
void TeamSize::end_block() {
    mean_ = block_.mean();
    block_ = {};
    if (until_trial_ <= 0.0 || wins_ > 0) begin_trial();
}

void TeamSize::begin_trial() {
    if (!can_go(way_)) way_ = way_ == Way::larger ? Way::smaller : Way::larger;
    is_trying_ = true;
}

void TeamSize::look_at_trial() {
    const double cost = block_.time - block_.steps * mean_;
    const bool is_over = block_.time >= block_time;
    const bool is_bad = block_.time >= 0.25 * block_time && block_.mean() > cut_off * mean_;
    if (!is_over && !is_bad) return;
    trial_cost_ += std::max(cost, 0.0);
    const bool is_larger = way_ == Way::larger;
    const double wins_below = is_larger ? larger_wins_below : smaller_wins_below;
    const bool has_won = block_.mean() < wins_below * mean_;
    wins_ = has_won ? wins_ + 1 : 0;
    if (!has_won) {
        give_up_trial();
    } else if (wins_ == (is_larger ? larger_wins_to_be_kept : smaller_wins_to_be_kept)) {
        keep_tried();
    }
    block_ = {};
    is_trying_ = false;
}

void TeamSize::keep_tried() {
    kept_ = tried();
    wins_ = 0;
    trial_cost_ = 0.0;
    until_trial_ = can_go(way_) ? 0.0 : trial_interval;
}

void TeamSize::give_up_trial() {
    until_trial_ = std::max(trial_interval, trial_cost_ / trial_share);
    trial_cost_ = 0.0;
    way_ = way_ == Way::larger ? Way::smaller : Way::larger;
}

}  // namespace dem
