// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall_distance.hpp"

namespace dem::runtime {

double wall_distance(const WallShape& shape, const WallState& state, const Vec3& point) {
    return std::visit([&](const auto& wall) { return wall_distance(wall, state, point); }, shape);
}

}  // namespace dem::runtime
