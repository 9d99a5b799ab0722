// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cover.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace dem {
namespace {

struct Bid {
    std::size_t gain;
    std::uint32_t candidate;
    /// Below in the heap.
    bool operator<(const Bid& other) const {
        return gain != other.gain ? gain < other.gain : candidate > other.candidate;
    }
};

/// No more cells have their centers in the ball: they fit into one that is larger by half a cell's
/// diagonal.
std::size_t most_cells(const Ball& ball, double cell_size) {
    const double r = ball.radius / cell_size + 0.5 * std::sqrt(3.0);
    return static_cast<std::size_t>(4.0 / 3.0 * pi * cube(r)) + 1;
}

bool is_reached(const CoverGoal& goal, const CellCover& cover, std::size_t count) {
    return cover.coverage() >= goal.coverage || count >= goal.count;
}

}  // namespace

void cover_greedily(std::span<const Ball> candidates, const CoverGoal& goal, CellCover& cover,
                    std::vector<std::uint32_t>& chosen) {
    std::vector<Bid> bids;
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
        bids.push_back({most_cells(candidates[i], cover.cell_size()), i});
    std::priority_queue<Bid> heap({}, std::move(bids));
    while (!heap.empty() && !is_reached(goal, cover, chosen.size())) {
        Bid top = heap.top();
        heap.pop();
        const std::size_t gain = cover.gain(candidates[top.candidate]);
        if (gain == 0) continue;
        top.gain = gain;
        if (!heap.empty() && top < heap.top()) {
            heap.push(top);
            continue;
        }
        chosen.push_back(top.candidate);
        cover.insert(candidates[top.candidate]);
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

}  // namespace dem
