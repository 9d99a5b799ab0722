// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball_rows.hpp"

#include <cstdint>
#include <vector>

namespace dem {

/// Which cells of a solid are covered by how many balls. A cell counts as covered when its center
/// is; the cells are so many that those cut by a surface average out. Balls may be taken out again.
class CellCover {
  public:
    /// Nothing is covered.
    explicit CellCover(const VoxelImage& solid);

    std::size_t cells() const { return cells_; }
    std::size_t uncovered() const { return uncovered_count_; }
    double coverage() const {
        return 1.0 - static_cast<double>(uncovered_count_) / static_cast<double>(cells_);
    }

    /// How many uncovered cells the ball would cover.
    std::size_t gain(const Ball& ball) const;

    /// How many cells no other ball covers; the ball is one of those inserted.
    std::size_t exclusive(const Ball& ball) const;

    void insert(const Ball& ball);

    /// Covers cells for good: the ball cannot be taken out.
    void mark(const Ball& ball);

    /// Takes out a ball that was inserted; appends the centers of the cells that it leaves
    /// uncovered.
    void erase(const Ball& ball, std::vector<Vec3>& uncovered_centers);
    void erase(const Ball& ball);

  private:
    std::size_t row(int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(uncovered_.grid().size[1]) +
                static_cast<std::size_t>(j)) *
               row_words_;
    }
    template <class Visit>
    void take_out(const Ball& ball, const Visit& visit);

    std::size_t row_words_;
    VoxelImage solid_;
    VoxelImage uncovered_;
    std::vector<std::uint16_t> counts_;  ///< of balls per cell, also outside the solid
    std::size_t cells_;
    std::size_t uncovered_count_;
};

}  // namespace dem
