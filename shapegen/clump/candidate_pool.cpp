// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/candidate_pool.hpp"

#include "shapegen/clump/candidates.hpp"
#include "shapegen/voxel/voxelize.hpp"

namespace dem::shapegen {

CandidatePool::CandidatePool(const SurfaceQuery& surface, double volume, const VoxelImage& cells,
                             const CandidateOptions& options)
    : surface_(surface),
      covered_(cells),
      options_(options),
      close_(0.02 * voxel_spacing(volume, options.per_diameter)),
      seeds_(static_cast<std::size_t>(0.5 * square(options.per_diameter))),
      most_seeds_(16 * seeds_) {
    const VoxelImage image = voxelize(surface.mesh(), voxel_spacing(volume, options.per_diameter));
    append(skeletal_balls(surface, image, options.skeleton, options.min_radius));
}

bool CandidatePool::extend() {
    if (seeds_ > most_seeds_) return false;
    append(surface_seeded_balls(surface_, seeds_, balls_, close_, options_.min_radius));
    seeds_ *= 4;
    return true;
}

void CandidatePool::append(const std::vector<Ball>& balls) {
    for (const Ball& ball : balls) covered_.mark(ball);
    balls_.insert(balls_.end(), balls.begin(), balls.end());
}

}  // namespace dem::shapegen
