// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball_tree.hpp"
#include "shapegen/clump/surface_samples.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::shapegen {

/// Surface samples in blocks of neighbors: the balls that may be nearest to one of a block are
/// looked up once for all of them.
class SampleBlocks {
  public:
    explicit SampleBlocks(std::span<const SurfaceSample> samples);

    /// What `tree`, of these `balls`, answers for each sample, in their order as given; the blocks
    /// are shared among the threads.
    std::vector<BallTree::Answer> nearest(const BallTree& tree, std::span<const Ball> balls) const;

  private:
    struct Block {
        Ball hull;  ///< around its samples
        std::uint32_t first, last;
    };
    std::vector<Vec3> points_;          ///< block after block
    std::vector<std::size_t> numbers_;  ///< of the samples, in that order
    std::vector<Block> blocks_;
};

}  // namespace dem::shapegen
