// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cover.hpp"

#include <algorithm>
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

std::vector<std::size_t> gains(std::span<const Ball> candidates, const CellCover& cover) {
    std::vector<std::size_t> result(candidates.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t i = 0; i < candidates.size(); ++i) result[i] = cover.gain(candidates[i]);
    return result;
}

bool is_reached(const CoverGoal& goal, const CellCover& cover, std::size_t count) {
    return cover.coverage() >= goal.coverage || count >= goal.count;
}

/// Points that a ball left uncovered: how large a part of them other balls hold, from a few of the
/// points or from more.
class Gap {
  public:
    explicit Gap(const std::vector<Vec3>& points)
        : rough_(thinned(points, 32)), fine_(thinned(points, 1024)) {}

    double rough_share(const Ball& ball) const { return share(rough_, ball); }
    double share(const Ball& ball) const { return share(fine_, ball); }

  private:
    static std::vector<Vec3> thinned(const std::vector<Vec3>& points, std::size_t most) {
        const std::size_t step = std::max<std::size_t>((points.size() + most - 1) / most, 1);
        std::vector<Vec3> result;
        for (std::size_t i = step / 2; i < points.size(); i += step) result.push_back(points[i]);
        return result.empty() ? points : result;
    }
    static double share(const std::vector<Vec3>& points, const Ball& ball) {
        const double r2 = square(ball.radius);
        std::size_t sum = 0;
        for (const Vec3& p : points) sum += (p - ball.center).squaredNorm() <= r2 ? 1U : 0U;
        return static_cast<double>(sum) / static_cast<double>(points.size());
    }

    std::vector<Vec3> rough_, fine_;
};

/// Looks for better places for balls, one at a time. `elsewhere_` estimates the candidates' gains
/// when all chosen balls are in place.
class Exchange {
  public:
    Exchange(std::span<const Ball> candidates, CellCover& cover)
        : candidates_(candidates), cover_(cover) {
        for (const std::size_t gain : gains(candidates, cover))
            elsewhere_.push_back(static_cast<double>(gain));
    }

    /// The candidate that covers most in place of `old`, which is taken out; it is put in.
    std::uint32_t replace(std::uint32_t old) {
        gap_points_.clear();
        cover_.erase(candidates_[old], gap_points_);
        std::uint32_t best = old;
        if (!gap_points_.empty()) best = find(old);
        cover_.insert(candidates_[best]);
        return best;
    }

  private:
    std::uint32_t find(std::uint32_t old) {
        constexpr std::size_t most_tried = 24;
        const Gap gap(gap_points_);
        rate(candidates_[old], gap);
        const std::size_t tried = std::min(bids_.size(), most_tried);
        std::partial_sort(bids_.begin(), bids_.begin() + static_cast<std::ptrdiff_t>(tried),
                          bids_.end(), [](const Bid& a, const Bid& b) { return b < a; });
        const auto open = static_cast<double>(gap_points_.size());
        Bid best{gap_points_.size(), old};
        for (std::size_t n = 0; n < tried; ++n) {
            const std::uint32_t i = bids_[n].candidate;
            const std::size_t gain = cover_.gain(candidates_[i]);
            const double in_gap = gap.share(candidates_[i]) * open;
            elsewhere_[i] = std::max(static_cast<double>(gain) - in_gap, 0.0);
            if (gain > best.gain) best = {gain, i};
        }
        return best.candidate;
    }

    /// Estimates for the candidates that may beat the old ball: their part of the gap and what they
    /// cover elsewhere.
    void rate(const Ball& old, const Gap& gap) {
        constexpr double doubt = 0.15;  // of a rough estimate
        const auto open = static_cast<double>(gap_points_.size());
        bids_.clear();
        for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
            const Ball& c = candidates_[i];
            if ((c.center - old.center).squaredNorm() >= square(c.radius + old.radius)) continue;
            if (elsewhere_[i] + (gap.rough_share(c) + doubt) * open < open) continue;
            const double gain = elsewhere_[i] + gap.share(c) * open;
            bids_.push_back({static_cast<std::size_t>(gain), i});
        }
    }

    std::span<const Ball> candidates_;
    CellCover& cover_;
    std::vector<double> elsewhere_;
    std::vector<Vec3> gap_points_;
    std::vector<Bid> bids_;
};

}  // namespace

double ceiling(std::span<const Ball> candidates, const VoxelImage& solid) {
    CellCover cover(solid);
    for (const Ball& ball : candidates) cover.mark(ball);
    return cover.coverage();
}

void cover_greedily(std::span<const Ball> candidates, const CoverGoal& goal, CellCover& cover,
                    std::vector<std::uint32_t>& chosen) {
    const std::vector<std::size_t> first = gains(candidates, cover);
    std::vector<Bid> bids;
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
        if (first[i] > 0) bids.push_back({first[i], i});
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

void drop_redundant(std::span<const Ball> candidates, double coverage, CellCover& cover,
                    std::vector<std::uint32_t>& chosen) {
    // What a ball covers alone grows when others go, so the least of stale values is a bound.
    const auto worse = [](const Bid& a, const Bid& b) { return b < a; };
    std::priority_queue<Bid, std::vector<Bid>, decltype(worse)> heap(worse);
    for (const std::uint32_t i : chosen) heap.push({cover.exclusive(candidates[i]), i});
    const auto spare = [&] {
        return static_cast<double>(cover.cells()) * (1.0 - coverage) -
               static_cast<double>(cover.uncovered());
    };
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
    }
}

std::size_t exchange(std::span<const Ball> candidates, CellCover& cover,
                     std::vector<std::uint32_t>& chosen) {
    Exchange search(candidates, cover);
    std::size_t exchanged = 0;
    for (std::uint32_t& ball : chosen) {
        const std::uint32_t better = search.replace(ball);
        exchanged += better != ball ? 1U : 0U;
        ball = better;
    }
    return exchanged;
}

std::vector<std::uint32_t> choose_cover(std::span<const Ball> candidates, const CoverGoal& goal,
                                        int sweeps, CellCover& cover) {
    std::vector<std::uint32_t> chosen;
    cover_greedily(candidates, goal, cover, chosen);
    const bool wants_coverage = cover.coverage() >= goal.coverage;
    if (wants_coverage) drop_redundant(candidates, goal.coverage, cover, chosen);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const std::size_t before = cover.uncovered();
        const std::size_t exchanged = exchange(candidates, cover, chosen);
        const std::size_t count = chosen.size();
        if (wants_coverage) drop_redundant(candidates, goal.coverage, cover, chosen);
        const bool helped = chosen.size() < count || cover.uncovered() < before;
        if (exchanged == 0 || !helped) break;
    }
    return chosen;
}

}  // namespace dem
