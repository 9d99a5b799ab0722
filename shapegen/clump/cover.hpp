// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/cell_cover.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// When a cover is good enough: at either of the two.
struct CoverGoal {
    double coverage = 1.0;  ///< of the cells
    std::size_t count = SIZE_MAX;
};

/// The coverage that all candidates together reach.
double ceiling(std::span<const Ball> candidates, const VoxelImage& solid);

/// The greedy weighted set cover of [MS Algorithm 2]: again and again the candidate that covers
/// most of what is uncovered, the first one of equals. Lazily: gains only fall, so a gain that was
/// up to date when it was on top of the heap cannot be beaten. `chosen` is extended; its balls are
/// in `cover`. Stops short of the goal when no candidate gains anything.
void cover_greedily(std::span<const Ball> candidates, const CoverGoal& goal, CellCover& cover,
                    std::vector<std::uint32_t>& chosen);

/// Takes out balls, the least useful first, as long as the coverage stays at `coverage`.
void drop_redundant(std::span<const Ball> candidates, double coverage, CellCover& cover,
                    std::vector<std::uint32_t>& chosen);

/// One sweep of exchanges: each ball in turn makes room for the candidate near it that then covers
/// most. Gives the number of balls that were exchanged. Coverage never falls.
std::size_t exchange(std::span<const Ball> candidates, CellCover& cover,
                     std::vector<std::uint32_t>& chosen);

/// All of it: greedy, then exchanges and drops until neither helps. For a goal of coverage fewer
/// balls come out than greedily, for a goal of count more is covered. At most `sweeps` exchanges
/// of every ball; 0 is plain greedy without redundant balls.
std::vector<std::uint32_t> choose_cover(std::span<const Ball> candidates, const CoverGoal& goal,
                                        int sweeps, CellCover& cover);

}  // namespace dem
