// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/exchange.hpp"

#include "common/math/elementary.hpp"
#include "common/threads/thread_team.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

/// Points that a ball left uncovered: how large a part of them other balls hold, from a few of the
/// points or from more.
class Exchange::Gap {
  public:
    explicit Gap(const std::vector<Vec3>& points)
        : rough_(thinned(points, 32)), fine_(thinned(points, 1024)) {}

    /// Whether the ball may hold that share of the points, by a few of them.
    bool may_hold(double wanted, const Ball& ball) const {
        const auto count = static_cast<double>(rough_.size());
        const auto most_missed = static_cast<std::ptrdiff_t>((1.0 - wanted) * count);
        std::ptrdiff_t missed = 0;
        for (const Vec3& p : rough_)
            if ((p - ball.center).squaredNorm() > square(ball.radius) && ++missed > most_missed)
                return false;
        return true;
    }
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

std::size_t Exchange::sweep(std::span<const Ball> candidates, std::vector<std::uint32_t>& chosen) {
    constexpr double reach = 1.5;  // of a ball's radius: its rivals lie about that far
    update_gains(candidates);
    std::size_t exchanged = 0;
    for (std::uint32_t& ball : chosen) {
        if (asked_[ball] > 0 && !has_changed_near(candidates[ball], reach, asked_[ball] - 1))
            continue;
        const std::uint32_t better = best_in_place_of(ball);
        if (better != ball) {
            note(candidates[ball]);
            note(candidates[better]);
            ++exchanged;
            ball = better;
        }
        asked_[better] = changes_.size() + 1;
    }
    return exchanged;
}

void Exchange::update_gains(std::span<const Ball> candidates) {
    candidates_ = candidates;
    const std::size_t known = gains_.size();
    if (candidates.size() > known) tree_.emplace(candidates);
    gains_.resize(candidates.size());
    asked_.resize(candidates.size(), 0);
    share_each(candidates.size(), 16, [&](std::size_t i) {
        if (i >= known || has_changed_near(candidates[i], 1.0, gains_at_))
            gains_[i] = static_cast<double>(cover_.gain(candidates[i]));
    });
    gains_at_ = changes_.size();
}

bool Exchange::has_changed_near(const Ball& ball, double reach, std::size_t since) const {
    for (std::size_t i = since; i < changes_.size(); ++i) {
        const Ball& change = changes_[i];
        if ((change.center - ball.center).squaredNorm() <
            square(change.radius + reach * ball.radius))
            return true;
    }
    return false;
}

/// The ball is taken out, the one that is given put in.
std::uint32_t Exchange::best_in_place_of(std::uint32_t old) {
    constexpr std::size_t most_tried = 24;
    gap_points_.clear();
    cover_.erase(candidates_[old], gap_points_);
    Rival best{static_cast<double>(gap_points_.size()), old};
    if (!gap_points_.empty()) {
        const Gap gap(gap_points_);
        find_rivals(candidates_[old], gap);
        const std::size_t tried = std::min(rivals_.size(), most_tried);
        const auto is_better = [](const Rival& a, const Rival& b) {
            return a.gain != b.gain ? a.gain > b.gain : a.candidate < b.candidate;
        };
        std::partial_sort(rivals_.begin(), rivals_.begin() + static_cast<std::ptrdiff_t>(tried),
                          rivals_.end(), is_better);
        const auto open = static_cast<double>(gap_points_.size());
        for (std::size_t n = 0; n < tried; ++n) {
            const std::uint32_t i = rivals_[n].candidate;
            const auto gain = static_cast<double>(cover_.gain(candidates_[i]));
            gains_[i] = std::max(gain - gap.share(candidates_[i]) * open, 0.0);
            if (gain > best.gain) best = {gain, i};
        }
    }
    cover_.insert(candidates_[best.candidate]);
    return best.candidate;
}

/// The candidates that may beat the old ball, by estimates: their part of the gap and what they
/// cover elsewhere.
void Exchange::find_rivals(const Ball& old, const Gap& gap) {
    constexpr double doubt = 0.15;  // of a rough estimate
    const auto open = static_cast<double>(gap_points_.size());
    rivals_.clear();
    // A ball of fewer cells than are to be won is no rival.
    const double smallest = cover_.cell_size() * (math::cbrt(0.75 / pi * open) - 0.9);
    tree_->visit_meeting(old, smallest, [&](std::uint32_t i) {
        const Ball& c = candidates_[i];
        if (!gap.may_hold(1.0 - doubt - gains_[i] / open, c)) return;
        rivals_.push_back({gains_[i] + gap.share(c) * open, i});
    });
}

}  // namespace dem::shapegen
