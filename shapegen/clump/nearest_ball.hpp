// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// Finds the ball whose surface is nearest to a point, or that holds it deepest: least |x - c| - r.
/// A tree of balls (center, range of radii); queries change nothing.
class NearestBall {
  public:
    struct Answer {
        std::uint32_t ball;
        double distance;  ///< |x - c| - r [m], negative inside
    };

    /// Needs at least one ball; keeps a copy.
    explicit NearestBall(std::span<const Ball> balls);

    /// Of equally near balls the one with the lowest index.
    Answer operator()(const Vec3& x) const;

  private:
    struct Node {
        Vec3 lower, upper;  ///< box of the centers
        double largest_radius;
        std::uint32_t first, last;  ///< of the order; a leaf
        std::uint32_t right;        ///< child; the left one is the next node; 0: a leaf
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t last);

    std::vector<Ball> balls_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace dem
