// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/ball_chain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dem::shapegen {

namespace {

constexpr double equal = 1e-6;  // of the radius

std::optional<AxialBall> ball_of(const ProfileSegment& segment) {
    const auto* arc = std::get_if<EllipseArc>(&segment);
    if (arc == nullptr) return std::nullopt;
    const double tolerance = equal * arc->a;
    const bool is_circle = std::abs(arc->a - arc->b) <= tolerance;
    if (!is_circle || std::abs(arc->center.x()) > tolerance) return std::nullopt;
    return AxialBall{arc->center.y(), arc->a};
}

bool is_same(const AxialBall& p, const AxialBall& q) {
    const double tolerance = equal * p.radius;
    return std::abs(p.z - q.z) <= tolerance && std::abs(p.radius - q.radius) <= tolerance;
}

/// The largest distance of points of a segment from the surface of a ball [m].
double deviation(const ProfileSegment& segment, const AxialBall& ball) {
    constexpr int steps = 16;
    double largest = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const Vec2 point = evaluate(segment, static_cast<double>(i) / steps).point;
        const double distance = (point - Vec2(0.0, ball.z)).norm() - ball.radius;
        largest = std::max(largest, std::abs(distance));
    }
    return largest;
}

}  // namespace

BallChain ball_chain(const Profile& profile) {
    BallChain chain;
    for (const ProfileSegment& segment : profile.segments()) {
        const auto ball = ball_of(segment);
        if (!ball) return {};
        const double room = -profile.signed_distance({0.0, ball->z});
        if (room < (1.0 - equal) * ball->radius) return {};
        // Two arcs of one ball follow one another: where another ball takes over, it holds the rest
        // of the way to the pole or the next ball does.
        if (chain.balls.empty() || !is_same(chain.balls.back(), *ball))
            chain.balls.push_back(*ball);
        chain.max_deviation = std::max(chain.max_deviation, deviation(segment, chain.balls.back()));
    }
    return chain;
}

}  // namespace dem::shapegen
