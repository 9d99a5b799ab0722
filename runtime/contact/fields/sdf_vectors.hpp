// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shapes/sr_shape.hpp"

namespace dem::runtime {

/// Distance vector of [SR] Sec. 2.4: bilinear interpolation of the distance vectors of the grid
/// points of the cell that holds (r, z), inside the grid. A template stores distances only, so the
/// vector of a grid point is its distance times the unit gradient there, by central differences
/// over the size of the cell. Points out of the body where the distance is positive, into it where
/// negative [m]. For ContactLaw::NodeNormal::vectors and ::averaged.
Vec2 interpolated_distance_vector(const SdfQuadtree& sdf, double r, double z);

}  // namespace dem::runtime
