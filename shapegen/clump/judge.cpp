// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/judge.hpp"

#include "common/math/elementary.hpp"
#include "common/shapes/mass_properties.hpp"
#include "shapegen/clump/ball_rows.hpp"
#include "shapegen/clump/sample_blocks.hpp"
#include "shapegen/clump/surface_samples.hpp"
#include "shapegen/voxel/voxelize.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

constexpr double per_diameter = 300.0;
constexpr std::size_t sample_count = 100'000;

VoxelImage rasterize(const VoxelGrid& grid, std::span<const Ball> balls) {
    VoxelImage image(grid);
    for (const Ball& ball : balls) {
        visit_rows(grid, ball,
                   [&](int first, int last, int j, int k) { image.insert_run(first, last, j, k); });
    }
    return image;
}

/// Sums of 1, x^2, y^2 and z^2 over the voxels of an image [m^2].
struct LatticeSums {
    double count = 0.0;
    Vec3 squares = Vec3::Zero();
};

/// Row by row, with exact sums of integers along each.
LatticeSums lattice_sums(const VoxelImage& image) {
    const VoxelGrid& grid = image.grid();
    const int row_words = (grid.size[0] + 63) / 64;
    const VoxelWord* words = image.words();
    LatticeSums sums;
    for (int k = 0; k < grid.size[2]; ++k) {
        for (int j = 0; j < grid.size[1]; ++j, words += row_words) {
            std::int64_t count = 0;
            std::int64_t first = 0;
            std::int64_t second = 0;
            for (int w = 0; w < row_words; ++w) {
                for (VoxelWord rest = words[w]; rest != 0; rest &= rest - 1) {
                    const std::int64_t i = 64 * w + std::countr_zero(rest);
                    ++count;
                    first += i;
                    second += i * i;
                }
            }
            const auto n = static_cast<double>(count);
            const double h = grid.spacing;
            sums.count += n;
            sums.squares +=
                Vec3(n * square(grid.origin.x()) +
                         2.0 * h * grid.origin.x() * static_cast<double>(first) +
                         h * h * static_cast<double>(second),
                     n * square(grid.coordinate(1, j)), n * square(grid.coordinate(2, k)));
        }
    }
    return sums;
}

std::size_t common_count(const VoxelImage& a, const VoxelImage& b) {
    const auto& size = a.grid().size;
    const auto words = static_cast<std::size_t>((size[0] + 63) / 64) *
                       static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
    std::size_t sum = 0;
    for (std::size_t w = 0; w < words; ++w)
        sum += static_cast<std::size_t>(std::popcount(a.words()[w] & b.words()[w]));
    return sum;
}

void measure_volumes(const SurfaceQuery& surface, double volume, std::span<const Ball> balls,
                     ClumpQuality& quality) {
    Aabb box = bounding_box(surface.mesh());
    for (const Ball& ball : balls) {
        box.lower = box.lower.cwiseMin(ball.center - Vec3::Constant(ball.radius));
        box.upper = box.upper.cwiseMax(ball.center + Vec3::Constant(ball.radius));
    }
    const VoxelGrid grid = enclosing_grid(box, voxel_spacing(volume, per_diameter));
    const VoxelImage solid = voxelize(surface.mesh(), grid);
    const VoxelImage clump = rasterize(grid, balls);
    const LatticeSums in_solid = lattice_sums(solid);
    const LatticeSums in_clump = lattice_sums(clump);
    const auto in_both = static_cast<double>(common_count(solid, clump));
    quality.coverage = in_both / in_solid.count;
    quality.outside = (in_clump.count - in_both) / in_solid.count;
    quality.volume_ratio = in_clump.count / in_solid.count;
    // The error of the lattice itself is nearly the same for both and cancels.
    const auto moment = [](const LatticeSums& sums, int axis) {
        return sums.squares.sum() - sums.squares[axis];
    };
    for (int axis = 0; axis < 3; ++axis)
        quality.moment_errors[axis] = moment(in_clump, axis) / moment(in_solid, axis) - 1.0;
}

void measure_surface(const SurfaceQuery& surface, double d_eq, std::span<const Ball> balls,
                     ClumpQuality& quality) {
    const std::vector<SurfaceSample> samples = surface_samples(surface.mesh(), sample_count);
    const auto nearest = SampleBlocks(samples).nearest(BallTree(balls), balls);
    double squares = 0.0;
    double slopes = 0.0;
    double deepest = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [ball, distance] = nearest[i];
        const Vec3 way = samples[i].point - balls[ball].center;
        const double angle =
            math::atan2(way.cross(samples[i].normal).norm(), way.dot(samples[i].normal));
        squares += square(distance);
        slopes += square(angle);
        deepest = std::max(deepest, distance);
    }
    const auto count = static_cast<double>(samples.size());
    quality.rms_deviation = std::sqrt(squares / count) / d_eq;
    quality.slope_rms = std::sqrt(slopes / count);
    quality.max_deviation_in = deepest / d_eq;
    double farthest = 0.0;
    for (const Ball& ball : balls)
        farthest = std::max(farthest, ball.radius + surface.signed_distance(ball.center));
    quality.max_deviation_out = farthest / d_eq;
}

}  // namespace

ClumpQuality judge(const SurfaceQuery& surface, double volume, std::span<const Ball> balls) {
    ClumpQuality quality;
    measure_volumes(surface, volume, balls, quality);
    measure_surface(surface, equivalent_diameter(volume), balls, quality);
    return quality;
}

}  // namespace dem::shapegen
