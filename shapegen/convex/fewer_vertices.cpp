// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/fewer_vertices.hpp"

#include "shapegen/convex/exact_hull.hpp"
#include "shapegen/solids/make_convex.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>

namespace dem::shapegen {

namespace {

/// Four corners of a large tetrahedron: the lowest in x, the farthest from it, from the line
/// through both, from the plane through the three.
std::array<std::size_t, 4> first_corners(const std::vector<Vec3>& points) {
    const auto farthest = [&](const auto& measure) {
        const auto less = [&](const Vec3& p, const Vec3& q) { return measure(p) < measure(q); };
        const auto found = std::max_element(points.begin(), points.end(), less);
        return static_cast<std::size_t>(found - points.begin());
    };
    const std::size_t a = farthest([](const Vec3& p) { return -p.x(); });
    const Vec3 origin = points[a];
    const std::size_t b = farthest([&](const Vec3& p) { return (p - origin).squaredNorm(); });
    const Vec3 along = (points[b] - origin).normalized();
    const std::size_t c =
        farthest([&](const Vec3& p) { return along.cross(p - origin).squaredNorm(); });
    const Vec3 normal = along.cross(points[c] - origin);
    const std::size_t d = farthest([&](const Vec3& p) { return std::abs(normal.dot(p - origin)); });
    return {a, b, c, d};
}

}  // namespace

FewerVertices with_fewer_vertices(const ConvexPolyhedron& solid, std::size_t count) {
    const std::vector<Vec3>& points = solid.vertices;
    if (points.size() <= count) return {solid, 0.0};
    std::vector<Vec3> chosen;
    std::vector<bool> is_chosen(points.size());
    for (const std::size_t k : first_corners(points)) {
        chosen.push_back(points[k]);
        is_chosen[k] = true;
    }
    FewerVertices result{exact_hull(chosen), 0.0};
    ConvexShape shape = rounded_around(result.solid, 0.0);
    // Distances only fall while the hull grows: those in the queue are upper bounds, and a point
    // whose distance of now is still the largest is the farthest (lazy greedy). Of equals the one
    // with the lowest index.
    using Entry = std::pair<double, std::size_t>;
    const auto is_below = [](const Entry& p, const Entry& q) {
        return p.first != q.first ? p.first < q.first : p.second > q.second;
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(is_below)> queue(is_below);
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!is_chosen[k]) queue.emplace(surface_distance(shape, points[k]).distance, k);
    while (!queue.empty()) {
        const std::size_t k = queue.top().second;
        queue.pop();
        const Entry now{surface_distance(shape, points[k]).distance, k};
        if (!queue.empty() && is_below(now, queue.top())) {
            queue.push(now);
            continue;
        }
        result.error_max = std::max(now.first, 0.0);
        if (chosen.size() == count) return result;
        chosen.push_back(points[k]);
        result.solid = exact_hull(chosen);
        shape = rounded_around(result.solid, 0.0);
    }
    result.error_max = 0.0;
    return result;
}

}  // namespace dem::shapegen
