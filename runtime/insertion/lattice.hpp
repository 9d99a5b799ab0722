// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/insertion/occupancy.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <vector>

namespace dem::runtime {

/// Places `insert = lattice` in the cells of a regular grid: cells as large as the largest body of
/// the group turned any way, or as its extents when the orientation is given, so that neighbors
/// cannot touch. Cells are filled along x, then y, then z (of a cylinder: its axis) from the lower
/// corner, each body shifted at random by up to the group's jitter; cells that are not wholly
/// inside the region, or not free, are left out. Throws Error saying how many the region holds when
/// that is less than the count.
std::vector<BodyPlacement> lattice_placements(const Scene& scene, std::uint32_t group,
                                              const Occupancy& occupancy);

}  // namespace dem::runtime
