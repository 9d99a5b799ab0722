// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/sample_blocks.hpp"

#include "common/threads/thread_team.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

namespace dem::shapegen {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Points = CGAL::Pointer_property_map<Kernel::Point_3>::const_type;
constexpr std::uint32_t block_size = 32;
constexpr std::size_t blocks_at_a_time = 4;  // some 10 us

std::vector<std::size_t> along_a_curve(std::span<const SurfaceSample> samples) {
    std::vector<Kernel::Point_3> points;
    points.reserve(samples.size());
    for (const SurfaceSample& s : samples)
        points.emplace_back(s.point.x(), s.point.y(), s.point.z());
    std::vector<std::size_t> numbers(samples.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    CGAL::hilbert_sort(numbers.begin(), numbers.end(),
                       CGAL::Spatial_sort_traits_adapter_3<Kernel, Points>(
                           CGAL::make_property_map(std::as_const(points))));
    return numbers;
}

Ball hull_of(std::span<const Vec3> points) {
    Vec3 lower = points.front();
    Vec3 upper = points.front();
    for (const Vec3& p : points) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    Ball hull{0.5 * (lower + upper), 0.0};
    for (const Vec3& p : points) hull.radius = std::max(hull.radius, (p - hull.center).norm());
    return hull;
}

}  // namespace

SampleBlocks::SampleBlocks(std::span<const SurfaceSample> samples)
    : numbers_(along_a_curve(samples)) {
    points_.reserve(samples.size());
    for (const std::size_t n : numbers_) points_.push_back(samples[n].point);
    const auto count = static_cast<std::uint32_t>(samples.size());
    for (std::uint32_t first = 0; first < count; first += block_size) {
        const std::uint32_t last = std::min(count, first + block_size);
        blocks_.push_back({hull_of(std::span(points_).subspan(first, last - first)), first, last});
    }
}

std::vector<BallTree::Answer> SampleBlocks::nearest(const BallTree& tree,
                                                    std::span<const Ball> balls) const {
    std::vector<BallTree::Answer> answers(points_.size());
    share_loop(blocks_.size(), blocks_at_a_time, [&](const LoopPart& part) {
        std::vector<std::uint32_t> candidates;
        std::uint32_t likely = 0;
        for (std::size_t b = part.begin; b < part.end; ++b) {
            const auto& [hull, first, last] = blocks_[b];
            // Between two points of the block the distance of a ball changes by the diameter at
            // most.
            const BallTree::Answer middle = tree.nearest(hull.center, likely);
            likely = middle.ball;
            const double rounding = 1e-9 * (hull.radius + balls[middle.ball].radius);
            const double reach = std::max(middle.distance + 2.0 * hull.radius, 0.0) + rounding;
            candidates.clear();
            tree.visit_meeting({hull.center, reach}, 0.0,
                               [&](std::uint32_t i) { candidates.push_back(i); });
            for (std::uint32_t k = first; k < last; ++k) {
                BallTree::Answer best{0, std::numeric_limits<double>::infinity()};
                for (const std::uint32_t i : candidates) {
                    const double distance = (points_[k] - balls[i].center).norm() - balls[i].radius;
                    if (distance < best.distance || (distance == best.distance && i < best.ball))
                        best = {i, distance};
                }
                answers[numbers_[k]] = best;
            }
        }
    });
    return answers;
}

}  // namespace dem::shapegen
