// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "runtime/walls/wall.hpp"

#include <span>
#include <vector>

namespace dem::runtime {

/// Where all walls of a scene are now.
struct MovingWalls {
    std::vector<WallState> state;
    /// Bound on the way that any point of the wall's surface has gone since time 0, within the
    /// domain [m]. A body of revolution that turns about its own axis moves none of its surface.
    std::vector<double> travel;
    double settled = infinite;  ///< when the bodies had settled for motions that wait for it [s]
};

/// The walls at time 0.
MovingWalls place_walls(std::span<const Wall> walls);

/// Moves the walls to time t [s].
void move_walls(MovingWalls& moving, std::span<const Wall> walls, const Aabb& domain, double t);

}  // namespace dem::runtime
