// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace dem::shapegen {

/// Triangles as a file holds them: nothing is promised about closedness, orientation or shared
/// corners. Indices are in range.
struct TriangleSoup {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The order of points by x, then y, then z.
inline bool is_before(const Vec3& a, const Vec3& b) {
    return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

}  // namespace dem::shapegen
