// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/cell_cover.hpp"
#include "shapegen/surface/surface_query.hpp"
#include "shapegen/thinning/thin.hpp"

#include <vector>

namespace dem::shapegen {

/// What candidates are made with.
struct CandidateOptions {
    double per_diameter;  ///< voxels per equivalent diameter d_eq
    Skeleton skeleton;
    double min_radius;  ///< [m]
};

/// The candidates of a solid: at first those of the skeleton, and more on request, seeded from the
/// surface ever more densely, where those do not reach far enough.
class CandidatePool {
  public:
    /// `volume` [m^3] is the solid's; coverage is counted on `cells`, which are the solid's.
    /// The surface is kept by reference.
    CandidatePool(const SurfaceQuery& surface, double volume, const VoxelImage& cells,
                  const CandidateOptions& options);

    const std::vector<Ball>& balls() const { return balls_; }
    double ceiling() const {
        return covered_.coverage();
    }  ///< coverage that all of them reach together

    /// A goal at the very ceiling would take every small ball there is; this is asked before a
    /// coverage is tried, or after it came out.
    bool has_room_for(double coverage) const { return 1.0 - ceiling() <= 0.5 * (1.0 - coverage); }

    /// Adds candidates, each time from four times as many points. False: there are enough.
    bool extend();

  private:
    void append(const std::vector<Ball>& balls);

    const SurfaceQuery& surface_;
    CellCover covered_;  ///< by all candidates
    CandidateOptions options_;
    double close_;  ///< a point is known to a ball that passes it like that [m]
    std::size_t seeds_, most_seeds_;
    std::vector<Ball> balls_;
};

}  // namespace dem::shapegen
