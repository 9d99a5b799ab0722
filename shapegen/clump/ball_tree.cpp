// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/ball_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::shapegen {
namespace {

constexpr int diameter_axis = 3;  // after x, y and z

double along(const Ball& ball, int axis) {
    return axis == diameter_axis ? 2.0 * ball.radius : ball.center[axis];
}

}  // namespace

BallTree::BallTree(std::span<const Ball> balls) : places_(balls.size()) {
    for (std::uint32_t i = 0; i < balls.size(); ++i) items_.push_back({balls[i], i});
    nodes_.reserve(items_.size());
    build(0, static_cast<std::uint32_t>(items_.size()));
    for (std::uint32_t n = 0; n < items_.size(); ++n) places_[items_[n].index] = n;
    const Node& all = nodes_.front();
    const double extent =
        std::max(all.lower.cwiseAbs().maxCoeff(), all.upper.cwiseAbs().maxCoeff());
    rounding_ = 32.0 * std::numeric_limits<double>::epsilon() * extent;
}

std::uint32_t BallTree::build(std::uint32_t first, std::uint32_t last) {
    constexpr std::uint32_t leaf = 4;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    const Ball& any = items_[first].ball;
    Node node{any.center, any.center, any.center, any.center, any.radius, first, last, 0};
    double smallest_radius = any.radius;
    for (std::uint32_t n = first; n < last; ++n) {
        const Ball& ball = items_[n].ball;
        node.lower = node.lower.cwiseMin(ball.center - Vec3::Constant(ball.radius));
        node.upper = node.upper.cwiseMax(ball.center + Vec3::Constant(ball.radius));
        node.lowest_center = node.lowest_center.cwiseMin(ball.center);
        node.highest_center = node.highest_center.cwiseMax(ball.center);
        node.largest_radius = std::max(node.largest_radius, ball.radius);
        smallest_radius = std::min(smallest_radius, ball.radius);
    }
    nodes_.push_back(node);
    if (last - first <= leaf) return index;
    int axis = 0;
    const double spread = (node.highest_center - node.lowest_center).maxCoeff(&axis);
    if (2.0 * (node.largest_radius - smallest_radius) > spread) axis = diameter_axis;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                     [axis](const Item& a, const Item& b) {
                         const double xa = along(a.ball, axis);
                         const double xb = along(b.ball, axis);
                         return xa != xb ? xa < xb : a.index < b.index;
                     });
    build(first, middle);
    const std::uint32_t right = build(middle, last);
    nodes_[index].right = right;
    return index;
}

BallTree::Answer BallTree::nearest(const Vec3& x, std::uint32_t likely) const {
    std::array<std::uint32_t, largest_stack> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    const auto distance_to = [&x](const Ball& ball) {
        return (x - ball.center).norm() - ball.radius;
    };
    Answer best{likely, distance_to(items_[places_[likely]].ball)};
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        // Outside of a ball it is at least as far as its box, and nowhere deeper in it than its
        // radius. A little more than these: rounding must not hide an equally near ball.
        const double reach = best.distance + rounding_;
        const Vec3 out = (node.lower - x).cwiseMax(x - node.upper).cwiseMax(0.0);
        if (out.squaredNorm() > square(std::max(reach, rounding_))) continue;
        const Vec3 off = (node.lowest_center - x).cwiseMax(x - node.highest_center).cwiseMax(0.0);
        const double limit = reach + node.largest_radius;
        if (limit < 0.0 || off.squaredNorm() > square(limit)) continue;
        if (node.right != 0) {
            stack[size++] = node.right;
            stack[size++] = index + 1;
            continue;
        }
        for (std::uint32_t n = node.first; n < node.last; ++n) {
            const std::uint32_t ball = items_[n].index;
            const double distance = distance_to(items_[n].ball);
            if (distance < best.distance || (distance == best.distance && ball < best.ball))
                best = {ball, distance};
        }
    }
    return best;
}

}  // namespace dem::shapegen
