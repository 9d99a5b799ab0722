// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"
#include "shapegen/surface/surface_query.hpp"
#include "shapegen/thinning/thin.hpp"

#include <optional>
#include <span>
#include <vector>

namespace dem::shapegen {

/// The largest ball inside the solid that touches its surface at q, `inward` being the unit vector
/// from there to the center: it shrinks from `largest` [m] until no second point of the surface is
/// inside by more than 1e-4 of its radius (Ma, Bae, Choi 2012). The radius is then the exact
/// distance of the center to the surface.
/// Empty when rounding leaves no ball.
std::optional<Ball> maximal_ball(const SurfaceQuery& surface, const Vec3& q, const Vec3& inward,
                                 double largest);

/// Balls from which a clump is chosen: one for each voxel of the skeleton of the image, which is
/// the solid's; the voxel's center is moved away from the nearest point of the surface until the
/// ball touches a second one. Smaller ones than `min_radius` [m] are left out.
std::vector<Ball> skeletal_balls(const SurfaceQuery& surface, const VoxelImage& image,
                                 Skeleton kind, double min_radius);

/// The largest balls that touch the surface at `count` evenly spread points, those left out that
/// one of the `known` balls passes by less than `close` [m]: they reach where the skeleton of
/// voxels does not.
std::vector<Ball> surface_seeded_balls(const SurfaceQuery& surface, std::size_t count,
                                       std::span<const Ball> known, double close,
                                       double min_radius);

}  // namespace dem::shapegen
