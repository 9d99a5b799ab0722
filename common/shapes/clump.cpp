// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/clump.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <tuple>

namespace dem {

namespace {

/// Halves the run along its longest side, at a power of two, until runs are single spheres: then
/// the spheres of every aligned run of 8, 64, ... lie together.
void order(std::span<ClumpSphere> run) {
    if (run.size() < 2) return;
    Vec3 lower = run[0].center();
    Vec3 upper = lower;
    for (const ClumpSphere& s : run) {
        lower = lower.cwiseMin(s.center());
        upper = upper.cwiseMax(s.center());
    }
    int axis = 0;
    (upper - lower).maxCoeff(&axis);
    const auto key = [axis](const ClumpSphere& s) {
        return std::make_tuple(s.center()[axis], s.x, s.y, s.z, s.radius, s.volume_share);
    };
    const std::size_t half = std::bit_ceil(run.size()) / 2;
    std::nth_element(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(half), run.end(),
                     [&](const ClumpSphere& a, const ClumpSphere& b) { return key(a) < key(b); });
    order(run.first(half));
    order(run.subspan(half));
}

/// A ball about the middle of the box of the spheres' centers.
Clump::Ball bounding_ball(std::span<const ClumpSphere> run) {
    Vec3 lower = run[0].center();
    Vec3 upper = lower;
    for (const ClumpSphere& s : run) {
        lower = lower.cwiseMin(s.center());
        upper = upper.cwiseMax(s.center());
    }
    const Vec3 middle = 0.5 * (lower + upper);
    double radius = 0.0;
    for (const ClumpSphere& s : run)
        radius = std::max(radius, (s.center() - middle).norm() + s.radius);
    return {middle.x(), middle.y(), middle.z(), radius * (1.0 + 1e-12)};
}

}  // namespace

double largest_radius(std::span<const ClumpSphere> spheres) {
    double largest = 0.0;
    for (const ClumpSphere& s : spheres) largest = std::max(largest, s.radius);
    return largest;
}

Clump make_clump(std::vector<ClumpSphere> spheres) {
    if (spheres.empty() || spheres.size() > Clump::most_spheres) {
        throw Error("clump", std::to_string(spheres.size()) + " spheres, expected 1 to " +
                                 std::to_string(Clump::most_spheres));
    }
    order(spheres);
    std::vector<Clump::Ball> balls;
    const std::size_t count = spheres.size();
    for (std::size_t run = 1; run < count;) {
        run *= 8;
        for (std::size_t first = 0; first < count; first += run) {
            balls.push_back(
                bounding_ball(std::span(spheres).subspan(first, std::min(run, count - first))));
        }
    }
    const double largest = largest_radius(spheres);
    return {std::move(spheres), std::move(balls), largest};
}

}  // namespace dem
