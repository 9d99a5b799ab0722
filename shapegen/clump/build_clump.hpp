// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/progress.hpp"
#include "common/shapes/mass_properties.hpp"
#include "shapegen/clump/cover.hpp"
#include "shapegen/clump/judge.hpp"
#include "shapegen/thinning/thin.hpp"

#include <memory>
#include <vector>

namespace dem::shapegen {

/// How clumps are made. Lengths in equivalent diameters d_eq of the body.
struct ClumpOptions {
    double per_diameter = 60.0;         ///< voxels per d_eq for the skeleton
    double cells_per_diameter = 160.0;  ///< on which coverage is counted while choosing
    Skeleton skeleton = Skeleton::surface;
    bool is_inscribed = false;  ///< no sphere leaves the body: no fit
    double protrusion = 0.01;   ///< the most a fitted sphere may reach out of the body
    double min_radius = 0.0;
    int sweeps = 12;  ///< of exchanges
    StageProgress progress = nullptr;
};

struct BuiltClump {
    std::vector<Ball> balls;  ///< body frame [m], the most useful first
    ClumpQuality quality;
    double ceiling = 0.0;  ///< coverage that all candidates together reach
};

/// Makes clumps of one solid for any number of goals [MS]: voxels, skeleton and candidates once,
/// then for each goal cover, fit, and what the judge says.
class ClumpMaker {
  public:
    /// The mesh is closed, outward and in its body frame.
    ClumpMaker(TriangleMesh mesh, const MassProperties& properties, const ClumpOptions& options);
    ~ClumpMaker();
    ClumpMaker(ClumpMaker&&) noexcept;
    ClumpMaker& operator=(ClumpMaker&&) noexcept;

    /// For a coverage: the count is that of inscribed spheres which reach it by the judge; the fit
    /// leaves the count alone. For a count: that many, or fewer where more add nothing. Throws
    /// Error when the coverage cannot be reached; it says what can.
    BuiltClump clump(const CoverGoal& goal);

    /// The fewest spheres found whose RMS deviation is at most `rms_deviation` (in d_eq): counts
    /// are bracketed by powers of two and then bisected on a logarithmic scale. Throws Error when
    /// the most spheres that a template holds do not get there.
    BuiltClump clump_within(double rms_deviation);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace dem::shapegen
