// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "runtime/scene.hpp"

namespace dem::runtime {

/// No coordinate of a body may be larger [m]: so far out positions lose the digits that contacts
/// need, and cells of grids their numbers.
inline constexpr double farthest_coordinate = 1e6;

/// Box about all finite walls, insertion regions, placed bodies and outlets of a scene at time 0.
/// Empty when there are none.
Aabb scene_extent(const Scene& scene);

/// The largest speed that a body may reach [m/s]: thrown at its start, fallen through the whole
/// scene and hit by the fastest wall.
double largest_expected_speed(const Scene& scene);

/// The fastest that a surface point of a body spins at the start [m/s].
double largest_rim_speed(const Scene& scene);

/// The speed of the fastest impact to expect [m/s]: as above, surface points of spinning bodies
/// added, but bodies on a lattice or packed from the bottom fall only to the ground under their
/// region and onto each other.
double largest_impact_speed(const Scene& scene);

/// The box that no center of mass may leave: the one of the case file, or the scene's extent with
/// room on every side for its largest edge, for what flies freely and for walls that move. It is
/// there to find bodies that got out, not to hold them.
Aabb domain(const Scene& scene);

}  // namespace dem::runtime
