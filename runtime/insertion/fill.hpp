// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/insertion/occupancy.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <vector>

namespace dem::runtime {

/// Places `insert = fill`: one body after the other as low (against gravity) as a search from a few
/// random places brings it, without an overlap. Denser than random places: 0.5 for spheres.
/// Throws Error saying how many the region holds when that is less than the count.
std::vector<BodyPlacement> fill_placements(const Scene& scene, std::uint32_t group,
                                           Occupancy& occupancy);

}  // namespace dem::runtime
