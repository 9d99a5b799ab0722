// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cover.hpp"

#include "common/threads/thread_team.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace dem::shapegen {
namespace {

struct Bid {
    std::size_t gain;
    std::uint32_t candidate;
    /// Below in the heap.
    bool operator<(const Bid& other) const {
        return gain != other.gain ? gain < other.gain : candidate > other.candidate;
    }
};

/// A bid and how many balls had been chosen when its gain was counted.
struct DatedBid : Bid {
    std::size_t counted_at;
};

/// No more cells have their centers in the ball: they fit into one that is larger by half a cell's
/// diagonal.
std::size_t most_cells(const Ball& ball, double cell_size) {
    const double r = ball.radius / cell_size + 0.5 * std::sqrt(3.0);
    return static_cast<std::size_t>(4.0 / 3.0 * pi * cube(r)) + 1;
}

/// Counts the highest bids anew, several at once: mostly a choice takes a hundred. Those that gain
/// nothing any more are left out.
void count_top(std::span<const Ball> candidates, const CellCover& cover, std::size_t now,
               std::priority_queue<DatedBid>& heap) {
    constexpr std::size_t most = 16;
    std::array<DatedBid, most> stale;
    std::size_t count = 0;
    for (; count < most && !heap.empty() && heap.top().counted_at != now; ++count) {
        stale[count] = heap.top();
        heap.pop();
    }
    const std::size_t next = heap.empty() ? 0 : heap.top().gain;
    share_each(count, 1, [&](std::size_t n) {
        DatedBid& bid = stale[n];
        const Ball& ball = candidates[bid.candidate];
        bid.gain = std::min(bid.gain, cover.gain_bound(ball));
        if (bid.gain < next) return;  // others are better as it seems
        bid.gain = cover.gain(ball);
        bid.counted_at = now;
    });
    for (std::size_t n = 0; n < count; ++n)
        if (stale[n].gain > 0) heap.push(stale[n]);
}

bool is_reached(const CoverGoal& goal, const CellCover& cover, std::size_t count) {
    return cover.coverage() >= goal.coverage || count >= goal.count;
}

}  // namespace

void cover_greedily(std::span<const Ball> candidates, const CoverGoal& goal, CellCover& cover,
                    std::vector<std::uint32_t>& chosen) {
    constexpr std::size_t never = SIZE_MAX;
    std::vector<DatedBid> bids;
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
        bids.push_back({{most_cells(candidates[i], cover.cell_size()), i}, never});
    std::priority_queue<DatedBid> heap({}, std::move(bids));
    while (!heap.empty() && !is_reached(goal, cover, chosen.size())) {
        if (heap.top().counted_at != chosen.size()) {
            count_top(candidates, cover, chosen.size(), heap);
            continue;
        }
        const std::uint32_t best = heap.top().candidate;
        heap.pop();
        chosen.push_back(best);
        cover.insert(candidates[best]);
    }
}

std::vector<std::uint32_t> drop_redundant(std::span<const Ball> candidates, double coverage,
                                          CellCover& cover, std::vector<std::uint32_t>& chosen) {
    // What a ball covers alone grows when others go, so the least of stale values is a bound.
    const auto worse = [](const Bid& a, const Bid& b) { return b < a; };
    std::priority_queue<Bid, std::vector<Bid>, decltype(worse)> heap(worse);
    for (const std::uint32_t i : chosen) heap.push({cover.exclusive(candidates[i]), i});
    const auto spare = [&] {
        return static_cast<double>(cover.cells()) * (1.0 - coverage) -
               static_cast<double>(cover.uncovered());
    };
    std::vector<std::uint32_t> dropped;
    while (!heap.empty() && static_cast<double>(heap.top().gain) <= spare()) {
        Bid least = heap.top();
        heap.pop();
        least.gain = cover.exclusive(candidates[least.candidate]);
        if (!heap.empty() && heap.top() < least) {
            heap.push(least);
            continue;
        }
        if (static_cast<double>(least.gain) > spare()) break;
        cover.erase(candidates[least.candidate]);
        std::erase(chosen, least.candidate);
        dropped.push_back(least.candidate);
    }
    return dropped;
}

void CoverSearch::drop(std::span<const Ball> candidates, double coverage) {
    for (const std::uint32_t ball : drop_redundant(candidates, coverage, cover_, chosen_))
        exchange_.note(candidates[ball]);
}

void CoverSearch::reach(std::span<const Ball> candidates, const CoverGoal& goal, int sweeps) {
    const std::size_t known = chosen_.size();
    cover_greedily(candidates, goal, cover_, chosen_);
    for (std::size_t i = known; i < chosen_.size(); ++i) exchange_.note(candidates[chosen_[i]]);
    const bool wants_coverage = cover_.coverage() >= goal.coverage;
    if (wants_coverage) drop(candidates, goal.coverage);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const std::size_t uncovered = cover_.uncovered();
        const std::size_t before = chosen_.size();
        const std::size_t exchanged = exchange_.sweep(candidates, chosen_);
        if (wants_coverage) drop(candidates, goal.coverage);
        // The last percent is not worth the time.
        const bool helped =
            static_cast<double>(chosen_.size()) < 0.99 * static_cast<double>(before) ||
            static_cast<double>(cover_.uncovered()) < 0.99 * static_cast<double>(uncovered);
        if (exchanged == 0 || !helped) break;
    }
}

}  // namespace dem::shapegen
