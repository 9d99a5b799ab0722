// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dem::shapegen {

/// Balls in a tree: halved at the median of that of x, y, z and the diameter in which they differ
/// most, so that small balls do not share a box with a large one. Built once; queries change
/// nothing and may run in any number of threads.
class BallTree {
  public:
    struct Answer {
        std::uint32_t ball;
        double distance;  ///< |x - c| - r [m], negative inside
    };

    /// Needs at least one ball; keeps a copy.
    explicit BallTree(std::span<const Ball> balls);

    /// The ball whose surface is nearest to x, or that holds it deepest: least |x - c| - r; of
    /// equally near balls the one with the lowest index. Sooner when `likely` is the ball, or near.
    Answer nearest(const Vec3& x, std::uint32_t likely = 0) const;

    /// Calls visit(index) for each ball of at least that radius which has a point in common with
    /// the inside of `other`.
    template <class Visit>
    void visit_meeting(const Ball& other, double smallest_radius, const Visit& visit) const;

  private:
    // Halving 2^32 balls leaves at most 32 right children waiting.
    static constexpr std::size_t largest_stack = 64;

    struct Node {
        Vec3 lower, upper;  ///< box of the balls
        Vec3 lowest_center, highest_center;
        double largest_radius;
        std::uint32_t first, last;  ///< of the items
        std::uint32_t right;        ///< child; the left one is the next node; 0: a leaf
    };
    struct Item {
        Ball ball;
        std::uint32_t index;
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t last);

    std::vector<Item> items_;
    std::vector<std::uint32_t> places_;  ///< of the balls among the items
    std::vector<Node> nodes_;
    double rounding_ = 0.0;  ///< of distances [m]
};

template <class Visit>
void BallTree::visit_meeting(const Ball& other, double smallest_radius, const Visit& visit) const {
    std::array<std::uint32_t, largest_stack> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        if (node.largest_radius < smallest_radius) continue;
        const Vec3& c = other.center;
        const Vec3 out = (node.lower - c).cwiseMax(c - node.upper).cwiseMax(0.0);
        if (out.squaredNorm() > square(other.radius + rounding_)) continue;
        if (node.right != 0) {
            stack[size++] = node.right;
            stack[size++] = index + 1;
            continue;
        }
        for (std::uint32_t n = node.first; n < node.last; ++n) {
            const Ball& ball = items_[n].ball;
            if (ball.radius >= smallest_radius &&
                (ball.center - c).squaredNorm() < square(ball.radius + other.radius))
                visit(items_[n].index);
        }
    }
}

}  // namespace dem::shapegen
