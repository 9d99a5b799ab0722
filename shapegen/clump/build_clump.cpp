// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/build_clump.hpp"

#include "common/error.hpp"
#include "shapegen/clump/candidates.hpp"
#include "shapegen/clump/fit.hpp"
#include "shapegen/voxel/voxelize.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

namespace dem {
namespace {

TriangleMesh in_body_frame(TriangleMesh mesh, const MassProperties& properties) {
    const Mat3 to_body = properties.principal_axes.toRotationMatrix().transpose();
    for (Vec3& p : mesh.vertices) p = to_body * (p - properties.center_of_mass);
    return mesh;
}

/// Candidates for a goal: those of the skeleton, and balls seeded from the surface where they do
/// not reach far enough.
class Candidates {
  public:
    Candidates(const SurfaceQuery& surface, double volume, const ClumpOptions& options)
        : surface_(surface),
          cells_(voxelize(surface.mesh(), voxel_spacing(volume, options.cells_per_diameter))),
          min_radius_(options.min_radius * equivalent_diameter(volume)) {
        const VoxelImage image =
            voxelize(surface.mesh(), voxel_spacing(volume, options.per_diameter));
        balls_ = skeletal_balls(surface, image, options.skeleton, min_radius_);
        ceiling_ = dem::ceiling(balls_, cells_);
        const auto per_area = static_cast<std::size_t>(0.5 * square(options.per_diameter));
        for (std::size_t seeds = per_area; !has_room(options.goal) && seeds <= 16 * per_area;
             seeds *= 4) {
            const std::vector<Ball> more = surface_seeded_balls(surface, seeds, min_radius_);
            balls_.insert(balls_.end(), more.begin(), more.end());
            ceiling_ = dem::ceiling(balls_, cells_);
        }
    }

    const std::vector<Ball>& balls() const { return balls_; }
    const VoxelImage& cells() const { return cells_; }
    double ceiling() const { return ceiling_; }

  private:
    /// A goal at the very ceiling would take every small ball there is.
    bool has_room(const CoverGoal& goal) const {
        constexpr double share_left = 0.5;
        return goal.coverage >= 1.0 || 1.0 - ceiling_ <= share_left * (1.0 - goal.coverage);
    }

    const SurfaceQuery& surface_;
    VoxelImage cells_;
    double min_radius_;
    std::vector<Ball> balls_;
    double ceiling_ = 0.0;
};

[[noreturn]] void refuse(const ClumpOptions& options, const Candidates& candidates) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "found a coverage of %.6g, expected at most %.4f: %zu candidate spheres reach no "
                  "more; more voxels or smaller spheres may",
                  options.goal.coverage, candidates.ceiling(), candidates.balls().size());
    throw Error("clump", text.data());
}

}  // namespace

BuiltClump build_clump(const TriangleMesh& input, const ClumpOptions& options) {
    BuiltClump clump;
    clump.mass_properties = mass_properties(input);
    const double volume = clump.mass_properties.volume;
    const double d_eq = equivalent_diameter(volume);
    const SurfaceQuery surface(in_body_frame(input, clump.mass_properties));
    const Candidates candidates(surface, volume, options);
    clump.ceiling = candidates.ceiling();
    const bool wants_coverage = options.goal.coverage < 1.0;
    if (wants_coverage && clump.ceiling < options.goal.coverage) refuse(options, candidates);
    CellCover cover(candidates.cells());
    for (const std::uint32_t i :
         choose_cover(candidates.balls(), options.goal, options.sweeps, cover))
        clump.balls.push_back(candidates.balls()[i]);
    if (!options.is_inscribed) {
        const std::size_t count = std::max<std::size_t>(20'000, 60 * clump.balls.size());
        const auto samples = surface_samples(surface.mesh(), count);
        fit(surface, samples, {options.protrusion * d_eq, options.min_radius * d_eq, 40},
            clump.balls);
    }
    clump.quality =
        judge(surface, volume, clump.mass_properties.principal_moments_per_density, clump.balls);
    return clump;
}

}  // namespace dem
