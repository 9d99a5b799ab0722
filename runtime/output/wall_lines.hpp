// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "runtime/walls/wall.hpp"

#include <span>
#include <utility>
#include <vector>

namespace dem::runtime {

using Segments = std::vector<std::pair<Vec3, Vec3>>;

/// Lines that show the walls around bodies which fill `bodies`, at a time [s], world frame [m]: the
/// outlines that the shapes give; of planes without end the part that the other planes and the box
/// leave, where they come near it.
Segments wall_lines(std::span<const Wall> walls, double time, const Aabb& bodies);

}  // namespace dem::runtime
