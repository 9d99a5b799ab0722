// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/clump/convergence.hpp"
#include "shapegen/pipeline/solid.hpp"

namespace dem::shapegen {

/// What a clump is made for; one of the three.
struct ClumpGoal {
    double coverage = 1.0;
    std::size_t count = 0;
    double rms_deviation = 0.0;  ///< [d_eq]
};

struct ClumpRequest {
    ClumpGoal goal;
    ClumpOptions options;
    double min_radius = 0.0;  ///< [m], when it is not given in d_eq
    bool wants_convergence = false;
};

struct CookedClump {
    ParticleTemplate shape;
    std::vector<ConvergenceRow> convergence;  ///< when it was asked for
    std::vector<std::string> lines;           ///< what the user should know about it
};

/// The template of a clump that stands for a solid: the solid's mass properties, exactly; spheres
/// whose shares of the mass have them too, as far as its certificate says; a bounding radius that
/// holds the solid and every sphere. A solid that is a union of balls gets those and no fit, where
/// as many were asked for. Throws Error where no clump does what was asked.
CookedClump cook_clump(const Solid& solid, const ClumpRequest& request);

}  // namespace dem::shapegen
