// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/candidates.hpp"

#include "common/threads/thread_team.hpp"
#include "shapegen/clump/ball_tree.hpp"
#include "shapegen/clump/surface_samples.hpp"

#include <algorithm>

namespace dem::shapegen {
namespace {

/// No ball inside the solid is larger than the narrow side of the box around it.
double largest_radius(const SurfaceQuery& surface) {
    const Aabb box = bounding_box(surface.mesh());
    return 0.5 * (box.upper - box.lower).minCoeff();
}

/// Calls make(i) for all i < count, shared among threads; what it gives is kept in order.
template <class Make>
std::vector<Ball> collect(std::size_t count, double min_radius, const Make& make) {
    std::vector<Ball> balls(count);
    share_each(count, 4, [&](std::size_t i) { balls[i] = make(i); });
    std::erase_if(balls, [&](const Ball& b) { return !(b.radius > std::max(min_radius, 0.0)); });
    return balls;
}

}  // namespace

std::optional<Ball> maximal_ball(const SurfaceQuery& surface, const Vec3& q, const Vec3& inward,
                                 double largest) {
    constexpr double touching = 1e-4;  // relative: what remains to gain is below any cell
    const double radius = surface.tangent_radius(q, inward, largest, touching);
    if (!(radius > 0.0)) return std::nullopt;
    const Vec3 center = q + radius * inward;
    return Ball{center, surface.nearest(center, radius).distance};
}

std::vector<Ball> skeletal_balls(const SurfaceQuery& surface, const VoxelImage& image,
                                 Skeleton kind, double min_radius) {
    const VoxelImage skeleton = thin(image, kind);
    const std::vector<Voxel> voxels = skeleton.voxels();
    const double largest = largest_radius(surface);
    return collect(voxels.size(), min_radius, [&](std::size_t i) {
        const Vec3 center = image.grid().center(voxels[i]);
        const SurfacePoint near = surface.nearest(center);
        if (near.distance == 0.0) return Ball{};
        const Vec3 inward = (center - near.point) / near.distance;
        // Mostly not much is left to grow, and a smaller ball is shrunk sooner.
        double enough = 1.5 * near.distance + image.grid().spacing;
        for (; enough < largest; enough *= 2.0) {
            const auto ball = maximal_ball(surface, near.point, inward, enough);
            if (!ball || ball->radius < 0.999 * enough)
                return ball.value_or(Ball{center, near.distance});
        }
        return maximal_ball(surface, near.point, inward, largest)
            .value_or(Ball{center, near.distance});
    });
}

std::vector<Ball> surface_seeded_balls(const SurfaceQuery& surface, std::size_t count,
                                       std::span<const Ball> known, double close,
                                       double min_radius) {
    const std::vector<SurfaceSample> samples = surface_samples(surface.mesh(), count);
    const double largest = largest_radius(surface);
    std::optional<BallTree> tree;
    if (!known.empty()) tree.emplace(known);
    return collect(samples.size(), min_radius, [&](std::size_t i) {
        if (tree && tree->nearest(samples[i].point).distance < close) return Ball{};
        return maximal_ball(surface, samples[i].point, -samples[i].normal, largest)
            .value_or(Ball{});
    });
}

}  // namespace dem::shapegen
