// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/profile/profile.hpp"

namespace dem::shapegen {

/// |interpolated - exact| of a distance field.
struct SdfError {
    // Within one interface cell of the surface, weighted by arc length.
    double mean = 0.0, rms = 0.0, max = 0.0;  ///< [m]
    double angle_rms = 0.0, angle_max = 0.0;  ///< of the gradient's direction [rad]
    // Anywhere in the grid, by the interpolant's own value.
    double max_outside = 0.0;       ///< where it is positive [m]
    double max_near_surface = 0.0;  ///< where it is within one interface cell of zero [m]
};

/// Measured against exact distances: nine depths at points l/1000 apart along the profile, and five
/// points in every cell that reaches outside. The angle jumps on the ridge that runs inwards from
/// a sharp edge, whatever the cell size: there angle_max is half the turning of the edge.
/// `interface_size`: edge of an interface cell [m].
SdfError sdf_error(const Profile& profile, const SdfQuadtree& sdf, double interface_size);

}  // namespace dem::shapegen
