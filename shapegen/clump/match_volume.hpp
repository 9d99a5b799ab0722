// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/fit.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <vector>

namespace dem::shapegen {

/// Grows or shrinks all balls by the same length, at most half a percent of `d_eq` [m], so that
/// their union has the volume of the solid as nearly as that allows: least squares of a surface
/// leave a few tenths of a percent, which the moments inherit. No ball comes to reach out of the
/// solid by more than the protrusion of the options, or smaller than their least radius.
void match_volume(const SurfaceQuery& surface, double d_eq, const FitOptions& options,
                  std::vector<Ball>& balls);

}  // namespace dem::shapegen
