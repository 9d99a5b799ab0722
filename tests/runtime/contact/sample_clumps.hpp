// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

/// Clumps in closed form for tests and benchmarks.
namespace dem::test {

/// An oblate spheroid of semi-axes a (across) and c (along z): `count` balls of its medial disc,
/// each of which touches its surface from inside, evenly spread.
inline Clump spheroid_clump(double a, double c, std::uint32_t count) {
    const double focal2 = a * a - c * c;
    const double rim = focal2 / a;  // of the medial disc
    std::vector<ClumpSphere> spheres;
    for (std::uint32_t k = 0; k < count; ++k) {
        const double rho = count == 1 ? 0.0 : rim * std::sqrt(k / (count - 1.0));
        const double turn = 2.0 * pi * std::numbers::phi * k;
        spheres.push_back({rho * std::cos(turn), rho * std::sin(turn), 0.0,
                           c * std::sqrt(1.0 - rho * rho / focal2),
                           4.0 / 3.0 * pi * a * a * c / count});
    }
    return make_clump(std::move(spheres));
}
/// [SR] Sec. 4.
inline Clump candy_clump(std::uint32_t count) {
    return spheroid_clump(6.585e-3, 3.395e-3, count);
}

/// `count` balls evenly on a circle about z; one: at the center.
inline Clump ring_clump(double circle, double radius, std::uint32_t count) {
    std::vector<ClumpSphere> spheres;
    for (std::uint32_t k = 0; k < count; ++k) {
        const double turn = 2.0 * pi * k / count;
        const double r = count == 1 ? 0.0 : circle;
        spheres.push_back({r * std::cos(turn), r * std::sin(turn), 0.0, radius, 1.0});
    }
    return make_clump(std::move(spheres));
}

/// Two balls with a smaller one between, along x.
inline Clump dumbbell_clump(double half_length, double radius) {
    return make_clump({{-half_length, 0.0, 0.0, radius, 1.0},
                       {0.0, 0.0, 0.0, 0.6 * radius, 1.0},
                       {half_length, 0.0, 0.0, radius, 1.0}});
}

}  // namespace dem::test
