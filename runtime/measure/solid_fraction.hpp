// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/measure/vessel.hpp"
#include "runtime/particles.hpp"

namespace dem::runtime {

/// The part of a layer of a vessel that particles fill.
struct SolidFraction {
    double overall = 0.0;
    double near_wall = 0.0;     ///< within a mean particle diameter of the side walls
    double core = 0.0;          ///< farther from them; 0 where the vessel is too narrow
    double bulk_density = 0.0;  ///< mass of the layer over its volume [kg/m^3]
};

/// Heights above a vessel's floor [m].
struct Layer {
    double bottom, top;
};

/// Counts which of 40 000 points, spread evenly over the layer, lie in a particle
/// (surface_distance.hpp); clumps count as the union of their spheres. Zero for an empty layer.
SolidFraction solid_fraction(const Particles& particles, const Scene& scene, const Vessel& vessel,
                             const Layer& layer);

/// Mean of the particles' d_eq [m].
double mean_diameter(const Particles& particles, const Scene& scene);

}  // namespace dem::runtime
