// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "runtime/walls/wall.hpp"

#include <span>
#include <utility>
#include <vector>

namespace dem::runtime {

using Segments = std::vector<std::pair<Vec3, Vec3>>;

/// What a picture shows, and from where.
struct WallView {
    MotionTime time = 0.0;
    Aabb bodies;  ///< what they fill [m]
    Vec3 towards_viewer = -Vec3::UnitY();
};

/// Lines that show the walls around bodies, world frame [m]: the outlines that the shapes give, and
/// where walls of triangles turn away from the viewer; of planes without end the part that the
/// other planes and the box of the bodies leave, where they come near it.
Segments wall_lines(std::span<const Wall> walls, const WallView& view);

}  // namespace dem::runtime
