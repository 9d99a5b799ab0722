// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/display_mesh.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/revolution/profile_samples.hpp"
#include "shapegen/revolution/rings.hpp"
#include "shapegen/revolution/surface_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem::shapegen {

namespace {

using Samples = std::vector<ProfileSample>;

double distance_to_chord(const Vec2& x, const Vec2& from, const Vec2& to) {
    const Vec2 way = to - from;
    const double length2 = way.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((x - from).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (x - from - t * way).norm();
}

/// Douglas-Peucker: marks the samples whose chords stay within `tolerance` of all samples. A stack
/// instead of recursion, since a table of points may be long.
std::vector<bool> thinned(const Samples& samples, double tolerance) {
    std::vector<bool> keep(samples.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, samples.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        double largest = tolerance;
        std::size_t farthest = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d =
                distance_to_chord(samples[i].point, samples[first].point, samples[last].point);
            if (d > largest) {
                largest = d;
                farthest = i;
            }
        }
        if (farthest == first) continue;
        keep[farthest] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    return keep;
}

/// Chords of a circle of radius r that leave it by at most `tolerance`.
std::uint32_t chords_around(double r, double tolerance) {
    const double cosine = std::max(1.0 - tolerance / r, 0.5);
    return static_cast<std::uint32_t>(std::max(std::ceil(pi / math::acos(cosine)), 8.0));
}

}  // namespace

DisplayMesh display_mesh(const Profile& profile, double tolerance) {
    const Samples samples = sample_profile(profile, 5.0 * tolerance);
    const std::vector<bool> keep = thinned(samples, 0.5 * tolerance);
    std::vector<Ring> rings{{0.0, profile.bottom_z(), 0, 0.0, 1, 0.0}};
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        const ProfileSample& s = samples[i];
        if (!keep[i] || s.point[0] <= 0.0) continue;
        rings.push_back({s.point[0], s.point[1], s.segment, s.t,
                         chords_around(s.point[0], 0.5 * tolerance), 0.0});
    }
    rings.push_back({0.0, profile.top_z(), 0, 1.0, 1, 0.0});
    const std::vector<Vec3> points = ring_points(rings);
    auto triangles = ring_triangles(rings);
    const double deviation = surface_deviation(profile, points, triangles);
    return {points, std::move(triangles), deviation};
}

}  // namespace dem::shapegen
