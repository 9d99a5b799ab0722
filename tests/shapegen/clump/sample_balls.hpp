// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/random.hpp"
#include "shapegen/clump/ball.hpp"

#include <vector>

namespace dem::test {

using namespace shapegen;

/// Balls with centers in the cube [-1, 1]^3 and radii from 0.1 to 0.6.
inline std::vector<Ball> random_balls(std::size_t count, std::uint64_t seed) {
    Random random(seed, 0);
    std::vector<Ball> balls(count);
    for (Ball& ball : balls) {
        for (int axis = 0; axis < 3; ++axis) ball.center[axis] = random.uniform(-1.0, 1.0);
        ball.radius = random.uniform(0.1, 0.6);
    }
    return balls;
}

}  // namespace dem::test
