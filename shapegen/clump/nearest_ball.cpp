// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/nearest_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace dem {

NearestBall::NearestBall(std::span<const Ball> balls)
    : balls_(balls.begin(), balls.end()), order_(balls.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, static_cast<std::uint32_t>(balls.size()));
}

std::uint32_t NearestBall::build(std::uint32_t first, std::uint32_t last) {
    constexpr std::uint32_t leaf = 4;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{balls_[order_[first]].center, balls_[order_[first]].center, 0.0, first, last, 0};
    for (std::uint32_t n = first; n < last; ++n) {
        const Ball& ball = balls_[order_[n]];
        node.lower = node.lower.cwiseMin(ball.center);
        node.upper = node.upper.cwiseMax(ball.center);
        node.largest_radius = std::max(node.largest_radius, ball.radius);
    }
    nodes_.push_back(node);
    if (last - first <= leaf) return index;
    int axis = 0;
    (node.upper - node.lower).maxCoeff(&axis);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double xa = balls_[a].center[axis];
                         const double xb = balls_[b].center[axis];
                         return xa != xb ? xa < xb : a < b;
                     });
    build(first, middle);
    const std::uint32_t right = build(middle, last);
    nodes_[index].right = right;
    return index;
}

NearestBall::Answer NearestBall::operator()(const Vec3& x) const {
    // Halving 2^32 balls leaves at most 32 right children waiting.
    std::array<std::uint32_t, 64> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    Answer best{0, std::numeric_limits<double>::infinity()};
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        const Vec3 out = (node.lower - x).cwiseMax(x - node.upper).cwiseMax(0.0);
        // A little below the bound: rounding must not hide an equally near ball.
        const double limit = best.distance + node.largest_radius * (1.0 + 1e-12);
        if (limit < 0.0 || out.squaredNorm() > square(limit)) continue;
        if (node.right != 0) {
            stack[size++] = node.right;
            stack[size++] = index + 1;
            continue;
        }
        for (std::uint32_t n = node.first; n < node.last; ++n) {
            const Ball& ball = balls_[order_[n]];
            const double distance = (x - ball.center).norm() - ball.radius;
            if (distance < best.distance || (distance == best.distance && order_[n] < best.ball))
                best = {order_[n], distance};
        }
    }
    return best;
}

}  // namespace dem
