// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/match_volume.hpp"

#include "shapegen/clump/ball_rows.hpp"
#include "shapegen/voxel/voxelize.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace dem::shapegen {
namespace {

constexpr double union_cells = 200.0;  // per d_eq: the union has a few millions
constexpr double most_growth = 0.005;  // [d_eq]

/// Cells of the union of balls that grow by a length, each up to its own largest radius.
class GrowingUnion {
  public:
    GrowingUnion(const SurfaceQuery& surface, const VoxelGrid& grid, const FitOptions& options,
                 std::span<const Ball> balls)
        : grid_(grid), balls_(balls) {
        for (const Ball& ball : balls) {
            const double depth = -surface.signed_distance(ball.center);
            most_.push_back(std::max(depth + options.protrusion, ball.radius));
            // A small ball keeps at least half of its radius.
            least_.push_back(
                std::max(std::min(options.min_radius, ball.radius), 0.5 * ball.radius));
        }
    }

    std::vector<Ball> grown(double growth) const {
        std::vector<Ball> result(balls_.begin(), balls_.end());
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i].radius = std::clamp(result[i].radius + growth, least_[i], most_[i]);
        return result;
    }

    double cells(double growth) const {
        VoxelImage image(grid_);
        for (const Ball& ball : grown(growth)) {
            visit_rows(grid_, ball, [&](int first, int last, int j, int k) {
                image.insert_run(first, last, j, k);
            });
        }
        return static_cast<double>(image.count());
    }

  private:
    VoxelGrid grid_;
    std::span<const Ball> balls_;
    std::vector<double> least_, most_;  ///< radii [m]
};

}  // namespace

void match_volume(const SurfaceQuery& surface, double d_eq, const FitOptions& options,
                  std::vector<Ball>& balls) {
    constexpr double close = 1e-4;
    const double most = most_growth * d_eq;
    Aabb box = bounding_box(surface.mesh());
    const Vec3 margin = Vec3::Constant(options.protrusion + most);
    box.lower -= margin;
    box.upper += margin;
    const VoxelGrid grid = enclosing_grid(box, d_eq / union_cells);
    const auto wanted = static_cast<double>(voxelize(surface.mesh(), grid).count());
    const GrowingUnion all(surface, grid, options, balls);
    double before = 0.0;
    double cells_before = all.cells(before);
    // At first as if the union had the surface of the solid.
    double slope = surface_area(surface.mesh()) / cube(grid.spacing);
    double growth = before;
    double missing = wanted - cells_before;
    for (int step = 0; step < 6 && std::abs(missing) > close * wanted; ++step) {
        growth = std::clamp(before + missing / slope, -most, most);
        if (growth == before) break;
        const double cells = all.cells(growth);
        const double rise = (cells - cells_before) / (growth - before);
        if (!(rise > 0.0)) break;
        slope = rise;
        before = growth;
        cells_before = cells;
        missing = wanted - cells;
    }
    balls = all.grown(growth);
}

}  // namespace dem::shapegen
