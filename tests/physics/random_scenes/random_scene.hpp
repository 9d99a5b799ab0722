// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <cstdint>

/// Mixtures of all kinds of shape, one seed a scene (docs/reliability.md, "Random scenes").
namespace dem::test {

using namespace runtime;

inline constexpr int kinds_per_scene = 6;
inline constexpr int bodies_per_kind = 6;
inline constexpr double fastest = 5.0;  ///< of the bodies at the start [m/s]

double largest_radius(const Scene& scene);  ///< of the bounding spheres [m]

/// Sizes up to 1:30, every wall and motion, both laws, restitution 0.01 to 1, friction 0 to 3.
/// Without walls there is no gravity, and the bodies fly apart.
Scene random_scene(std::uint64_t seed, bool has_walls);

/// The same with walls that stand, and a law that takes energy from whatever moves: restitution 0.1
/// to 0.8, friction 0.3 to 3, rolling resistance.
Scene resting_scene(std::uint64_t seed);

}  // namespace dem::test
