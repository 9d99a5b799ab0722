// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace dem {

/// Triangles as a file holds them: nothing is promised about closedness, orientation or shared
/// corners. Indices are in range.
struct TriangleSoup {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace dem
