// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/cell_cover.hpp"
#include "shapegen/clump/exchange.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::shapegen {

/// When a cover is good enough: at either of the two.
struct CoverGoal {
    double coverage = 1.0;  ///< of the cells
    std::size_t count = SIZE_MAX;
};

/// The greedy weighted set cover of [MS Algorithm 2]: again and again the candidate that covers
/// most of what is uncovered, the first one of equals. Lazily: gains only fall, so a gain that was
/// up to date when it was on top of the heap cannot be beaten; at first the volume of a ball bounds
/// it. `chosen` is extended; its balls are in `cover`. Stops short of the goal when no candidate
/// gains anything.
void cover_greedily(std::span<const Ball> candidates, const CoverGoal& goal, CellCover& cover,
                    std::vector<std::uint32_t>& chosen);

/// Takes out balls, the least useful first, as long as the coverage stays at `coverage`; gives
/// them.
std::vector<std::uint32_t> drop_redundant(std::span<const Ball> candidates, double coverage,
                                          CellCover& cover, std::vector<std::uint32_t>& chosen);

/// Chooses balls for a goal: greedily, then exchanges and drops until neither helps. For a goal of
/// coverage fewer balls come out than greedily, for a goal of count more is covered.
class CoverSearch {
  public:
    explicit CoverSearch(const VoxelImage& solid) : cover_(solid), exchange_(cover_) {}
    CoverSearch(const CoverSearch&) = delete;
    CoverSearch& operator=(const CoverSearch&) = delete;

    /// Goes on from what is chosen. Candidates may have been appended since the last call. At most
    /// `sweeps` exchanges of every ball; 0 is plain greedy without redundant balls.
    void reach(std::span<const Ball> candidates, const CoverGoal& goal, int sweeps);

    const std::vector<std::uint32_t>& chosen() const { return chosen_; }
    double coverage() const { return cover_.coverage(); }

  private:
    void drop(std::span<const Ball> candidates, double coverage);

    CellCover cover_;
    Exchange exchange_;
    std::vector<std::uint32_t> chosen_;
};

}  // namespace dem::shapegen
