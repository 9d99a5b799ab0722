// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/ball.hpp"
#include "shapegen/clump/surface_samples.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <span>
#include <vector>

namespace dem::shapegen {

struct FitOptions {
    double protrusion = 0.0;  ///< how far a ball may reach out of the solid [m]
    double min_radius = 0.0;  ///< [m]
    int steps = 40;
};

/// Moves and resizes balls until their union follows the surface of the solid best in the sense of
/// least squares: each point of the surface is assigned to the ball it is nearest to, or deepest
/// in, and each ball takes a damped Gauss-Newton step on its own points; again and again. A ball
/// keeps its center inside, and one that may not grow slides to where it may. The points
/// (SurfaceSample) each stand for the same area.
void fit(const SurfaceQuery& surface, std::span<const SurfaceSample> samples,
         const FitOptions& options, std::vector<Ball>& balls);

}  // namespace dem::shapegen
