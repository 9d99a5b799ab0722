// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <span>

namespace dem::shapegen {

/// How well a union of balls stands for a solid; lengths in equivalent diameters d_eq.
struct ClumpQuality {
    double coverage = 0.0;           ///< of the solid's volume, by the union
    double outside = 0.0;            ///< volume of the union outside the solid, over the solid's
    double volume_ratio = 0.0;       ///< volume of the union over the solid's
    double rms_deviation = 0.0;      ///< of the solid's surface from the union: |x - c| - r, least
    double max_deviation_in = 0.0;   ///< deepest gap between the solid's surface and the union
    double max_deviation_out = 0.0;  ///< how far the union reaches out of the solid
    Vec3 moment_errors = Vec3::Zero();  ///< of the union's moments about body x, y, z, relative
    double slope_rms = 0.0;             ///< angle between the normals of solid and union [rad]
};

/// Measures without anything the clump was made from: volumes and moments by lattice points
/// d_eq / 300 apart, exactly inside or outside of the mesh; deviations at 100 000 points evenly
/// spread over the surface. The solid is in its body frame and has the volume `volume` [m^3].
ClumpQuality judge(const SurfaceQuery& surface, double volume, std::span<const Ball> balls);

}  // namespace dem::shapegen
