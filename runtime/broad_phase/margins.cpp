// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/broad_phase/margins.hpp"

#include <algorithm>
#include <limits>

namespace dem::runtime {

namespace {

/// Steps between rebuilds to aim at: a rebuild costs about as much as four steps
/// (docs/time-loop.md), a longer interval makes longer lists.
constexpr double rebuild_interval = 200.0;
/// Margin of a body at rest, and the largest margin, in bounding radii.
constexpr double least_margin = 0.02;
constexpr double largest_margin = 0.5;
/// Margin of a moving wall, in the smallest bounding radius.
constexpr double moving_wall_margin = 0.1;

}  // namespace

std::vector<double> margins(const Particles& particles, const Scene& scene,
                            std::span<const double> surface_reach, double dt) {
    if (scene.run.skin) return std::vector<double>(particles.size(), 0.5 * *scene.run.skin);
    std::vector<double> result(particles.size());
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const BodyKind& kind = scene.kinds[particles.kind[i]];
        const double radius = scene.shapes[kind.shape].bounding_radius;
        const double speed =
            particles.velocity[i].norm() +
            surface_reach[particles.kind[i]] * particles.angular_velocity[i].norm();
        // In this order the largest also stands for a speed that is no number.
        result[i] = std::min(largest_margin * radius,
                             least_margin * radius + rebuild_interval * dt * speed);
    }
    return result;
}

std::vector<double> wall_margins(const Scene& scene) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const BodyKind& kind : scene.kinds) {
        smallest = std::min(smallest, scene.shapes[kind.shape].bounding_radius);
    }
    const double margin = scene.run.skin ? 0.5 * *scene.run.skin : moving_wall_margin * smallest;
    std::vector<double> result;
    for (const Wall& wall : scene.walls) {
        result.push_back(wall.motion.moves() ? margin : 0.0);
    }
    return result;
}

}  // namespace dem::runtime
