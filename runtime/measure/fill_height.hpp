// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/measure/vessel.hpp"
#include "runtime/particles.hpp"

namespace dem::runtime {

/// How high a bed reaches, three ways (docs/time-loop.md), along `up` from the vessel's floor, or
/// from the world's origin where there is no vessel [m].
struct FillHeight {
    double highest = 0.0;  ///< the highest point of any particle: what experiments report
    double top_ten = 0.0;  ///< mean of the tops of the ten highest particles
    double surface = 0.0;  ///< mean height of the surface that is seen from above
};

/// All zero without particles. The surface is met by vertical lines a twentieth of the mean
/// particle diameter apart (1/1000 of a bed's radius if that is more); lines that meet no particle
/// count as height 0. Bodies are taken as their display meshes, spheres exactly.
FillHeight fill_height(const Particles& particles, const Scene& scene);

}  // namespace dem::runtime
