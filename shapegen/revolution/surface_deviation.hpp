// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace dem::shapegen {

/// The largest distance of triangles with vertices on the surface from the true surface [m]: exact
/// distances at the centroids and the middles of the edges.
double surface_deviation(const Profile& profile, std::span<const Vec3> points,
                         std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace dem::shapegen
