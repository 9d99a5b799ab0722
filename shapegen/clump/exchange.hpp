// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball_tree.hpp"
#include "shapegen/clump/cell_cover.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dem::shapegen {

/// Looks for better places for chosen balls, one at a time: each makes room for the candidate near
/// it that then covers most. Remembers what it has asked in vain; whoever changes the cover between
/// two sweeps calls note().
class Exchange {
  public:
    /// Candidates may be appended later: sweep() is told all of them.
    explicit Exchange(CellCover& cover) : cover_(cover) {}

    /// One sweep over all balls but those around which nothing has changed since they were asked
    /// last. Gives the number of balls that were exchanged. Coverage never falls.
    std::size_t sweep(std::span<const Ball> candidates, std::vector<std::uint32_t>& chosen);

    /// A ball was put in or taken out.
    void note(const Ball& ball) { changes_.push_back(ball); }

  private:
    class Gap;
    struct Rival {
        double gain;  ///< estimated, in cells
        std::uint32_t candidate;
    };

    void update_gains(std::span<const Ball> candidates);
    bool has_changed_near(const Ball& ball, double reach, std::size_t since) const;
    std::uint32_t best_in_place_of(std::uint32_t old);
    void find_rivals(const Ball& old, const Gap& gap);

    CellCover& cover_;
    std::span<const Ball> candidates_;
    std::optional<BallTree> tree_;  ///< of the candidates
    std::vector<Ball> changes_;
    std::vector<std::size_t> asked_;  ///< 1 + changes before a ball was asked last; 0: never
    /// What each candidate would gain when all chosen balls are in place; exact at the beginning of
    /// a sweep but for changes that only just touch it.
    std::vector<double> gains_;
    std::size_t gains_at_ = 0;  ///< changes before the gains were computed
    std::vector<Vec3> gap_points_;
    std::vector<Rival> rivals_;
};

}  // namespace dem::shapegen
