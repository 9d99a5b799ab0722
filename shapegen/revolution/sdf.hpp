// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/profile/profile.hpp"

#include <cstdint>

namespace dem::shapegen {

/// Cells per major axis length l at each level [SR 2.3]. The ratios are powers of two: a seam is
/// then continuous (every kink of the coarse side is a grid point of the fine side).
struct SdfResolution {
    std::uint32_t base = 50;
    std::uint32_t interface = 200;
    std::uint32_t corner = 800;
};

/// Bounds of the cells per l: below, the band about the surface would be the whole body; above, the
/// values would no longer fit into the 32 bits that address them.
inline constexpr std::uint32_t fewest_base_cells = 10;
inline constexpr std::uint32_t most_cells = 6400;

/// Throws UsageError unless base <= interface <= corner with ratios that are powers of two.
void check_resolution(const SdfResolution& resolution);

/// The exact signed distance of the half cross-section at the grid points of a two-level grid.
/// Interface cells reach 0.058 l inwards, where the nodes of a partner can be: a run stops at an
/// overlap of 10 % of the radius of equal volume, which is largest for a cylinder as high as wide,
/// 0.572 l. They reach one interface cell outwards, and one more at either end because the values
/// beside a seam are those of the coarser side. Corner
/// cells are the base cells within 0.01 l of a corner. At least one base cell of margin surrounds
/// the cross-section, and at least `least_margin` [m]. Measured in docs/decisions/sdf-quadtree.md.
/// The slacks are left at zero: they come from sdf_error.
SdfQuadtree signed_distance_field(const Profile& profile, const SdfResolution& resolution,
                                  double least_margin = 0.0);

}  // namespace dem::shapegen
