// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/mass_properties.hpp"
#include "shapegen/clump/cover.hpp"
#include "shapegen/clump/judge.hpp"
#include "shapegen/thinning/thin.hpp"

#include <vector>

namespace dem {

/// What a clump is made for, and how. Lengths in equivalent diameters d_eq of the body.
struct ClumpOptions {
    CoverGoal goal;                     ///< a coverage or a count of spheres
    double per_diameter = 60.0;         ///< voxels per d_eq for the skeleton
    double cells_per_diameter = 160.0;  ///< on which coverage is counted while choosing
    Skeleton skeleton = Skeleton::surface;
    bool is_inscribed = false;  ///< no sphere leaves the body: no fit
    double protrusion = 0.01;   ///< the most a fitted sphere may reach out of the body
    double min_radius = 0.0;
    int sweeps = 12;  ///< of exchanges
};

struct BuiltClump {
    std::vector<Ball> balls;         ///< body frame [m], the most useful first
    MassProperties mass_properties;  ///< of the body, exact for its mesh
    ClumpQuality quality;
    double ceiling = 0.0;  ///< coverage that all candidates together reach
};

/// A clump of spheres for a closed, outward mesh [MS]: voxels, skeleton, candidates, cover, fit;
/// then what the judge says. For a goal of coverage the count is that of inscribed spheres which
/// reach it; the fit leaves the count alone. Throws Error when the coverage cannot be reached.
BuiltClump build_clump(const TriangleMesh& mesh, const ClumpOptions& options);

}  // namespace dem
