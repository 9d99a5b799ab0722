// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/measure/vessel.hpp"
#include "runtime/particles.hpp"

namespace dem {

/// How high a bed reaches, three ways (docs/time-loop.md), along `up` from the vessel's floor, or
/// from the world's origin where there is no vessel [m].
struct FillHeight {
    double highest = 0.0;  ///< the highest point of any particle: what experiments report
    double top_ten = 0.0;  ///< mean of the tops of the ten highest particles
    double surface = 0.0;  ///< area-weighted mean over a polar grid of the highest point per cell
};

/// All zero without particles. The polar grid has rings about one mean particle diameter wide, of
/// cells about as long as wide; cells that no particle covers count as height 0.
FillHeight fill_height(const Particles& particles, const Scene& scene);

}  // namespace dem
