// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/moving_walls.hpp"

namespace dem::runtime {

namespace {

double largest_distance(const Aabb& box, const Vec3& x) {
    return (x - box.lower).cwiseAbs().cwiseMax((x - box.upper).cwiseAbs()).norm();
}

// How far a point of the surface within `reach` [m] of the wall's origin can have gone.
double surface_travel(const WallShape& shape, const WallState& before, const WallState& after,
                      double reach) {
    const double turn = std::visit(
        [&](const auto& wall) {
            return wall.surface_turn(before.body.orientation, after.body.orientation);
        },
        shape);
    return (after.position - before.position).norm() + turn * reach;
}

}  // namespace

MovingWalls place_walls(std::span<const Wall> walls) {
    MovingWalls moving;
    for (const Wall& wall : walls) moving.state.push_back(wall_state(wall, 0.0));
    moving.travel.assign(walls.size(), 0.0);
    return moving;
}

void move_walls(MovingWalls& moving, std::span<const Wall> walls, const Aabb& domain, double t) {
    for (std::size_t w = 0; w < walls.size(); ++w) {
        if (!walls[w].motion.moves()) continue;
        const WallState now = wall_state(walls[w], {t, moving.settled});
        const double reach = largest_distance(domain, now.position);
        moving.travel[w] += surface_travel(walls[w].shape, moving.state[w], now, reach);
        moving.state[w] = now;
    }
}

}  // namespace dem::runtime
