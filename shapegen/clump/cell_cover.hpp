// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"
#include "shapegen/voxel/voxel_image.hpp"

#include <cstdint>
#include <vector>

namespace dem::shapegen {

/// Which cells of a solid are covered by how many balls. A cell counts as covered when its center
/// is; the cells are so many that those cut by a surface average out. Balls may be taken out again.
///
/// Cells lie in bricks of 4 x 4 x 4, one bit each in a word. Once most of the solid is covered most
/// words are zero, so that what a ball would gain costs little more than looking at them.
class CellCover {
  public:
    /// Nothing is covered.
    explicit CellCover(const VoxelImage& solid);

    std::size_t cells() const { return cells_; }
    std::size_t uncovered() const { return uncovered_count_; }
    double cell_size() const { return grid_.spacing; }  ///< [m]
    double coverage() const {
        return 1.0 - static_cast<double>(uncovered_count_) / static_cast<double>(cells_);
    }

    /// How many uncovered cells the ball would cover.
    std::size_t gain(const Ball& ball) const;

    /// No less than gain() and sooner counted: by the uncovered cells of whole blocks.
    std::size_t gain_bound(const Ball& ball) const;

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
    /// One bit for each brick, rows along x beginning with a new word.
    using BrickBits = std::vector<VoxelWord>;

    template <class Visit>
    void visit_bricks(const Ball& ball, const BrickBits& which, const Visit& visit) const;
    std::size_t block_of(std::size_t brick) const;
    VoxelWord& word_of(BrickBits& bits, std::size_t brick) const;
    VoxelWord bit_of(std::size_t brick) const;
    template <class Visit>
    void take_out(const Ball& ball, const Visit& visit);
    Vec3 center(std::size_t brick, int bit) const;

    VoxelGrid grid_;
    std::array<int, 3> bricks_{};  ///< along each axis
    std::size_t row_words_ = 0;    ///< of BrickBits
    BrickBits filled_, open_;      ///< bricks with cells, and with uncovered ones
    std::vector<VoxelWord> solid_;
    std::vector<VoxelWord> uncovered_;
    std::array<int, 3> blocks_{};                 ///< of 2 x 2 x 2 bricks, along each axis
    std::vector<std::uint16_t> block_uncovered_;  ///< cells in each
    /// Numbers of balls, from the first one inserted on: those that hold a whole brick, and, cell
    /// by cell, the others.
    std::vector<std::uint16_t> brick_counts_, cell_counts_;
    std::size_t cells_ = 0;
    std::size_t uncovered_count_ = 0;
};

}  // namespace dem::shapegen
