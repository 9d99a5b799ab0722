// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/measure/vessel.hpp"
#include "runtime/particles.hpp"

namespace dem {

/// The part of a vessel that particles fill, from the floor to a height.
struct SolidFraction {
    double overall = 0.0;    ///< volume of all particles over that of the vessel
    double near_wall = 0.0;  ///< within a mean particle diameter of the side walls
    double core = 0.0;       ///< farther from them; 0 where the vessel is too narrow
};

/// `height` above the vessel's floor [m]. `overall` takes the particles' own volumes. The two
/// others count which of 40 000 points, spread evenly, lie in a particle (surface_distance.hpp):
/// clumps count as the union of their spheres.
SolidFraction solid_fraction(const Particles& particles, const Scene& scene, const Vessel& vessel,
                             double height);

/// Mean of the particles' d_eq [m].
double mean_diameter(const Particles& particles, const Scene& scene);

}  // namespace dem
