// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/t_junctions.hpp"

#include "shapegen/repair/soup_cleaning.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace dem::shapegen {
namespace {

using PointIndices = std::vector<std::uint32_t>;

/// The ends of the open edges, sorted by each coordinate, to look up those near an edge.
std::array<PointIndices, 3> sorted_ends(const TriangleSoup& soup,
                                        const std::vector<EdgeSide>& edges) {
    std::array<PointIndices, 3> sorted;
    for (const EdgeSide& edge : edges) {
        sorted[0].push_back(edge.low);
        sorted[0].push_back(edge.high);
    }
    std::sort(sorted[0].begin(), sorted[0].end());
    sorted[0].erase(std::unique(sorted[0].begin(), sorted[0].end()), sorted[0].end());
    sorted[1] = sorted[2] = sorted[0];
    for (int axis = 0; axis < 3; ++axis) {
        PointIndices& points = sorted[static_cast<std::size_t>(axis)];
        std::stable_sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
            return soup.points[a][axis] < soup.points[b][axis];
        });
    }
    return sorted;
}

/// The points in the slab around an edge that holds the fewest: of the three across the axes.
std::span<const std::uint32_t> candidates(const TriangleSoup& soup,
                                          const std::array<PointIndices, 3>& sorted,
                                          const Vec3& low, const Vec3& high) {
    std::span<const std::uint32_t> fewest = sorted[0];
    for (int axis = 0; axis < 3; ++axis) {
        const PointIndices& points = sorted[static_cast<std::size_t>(axis)];
        const auto first = std::partition_point(points.begin(), points.end(), [&](std::uint32_t p) {
            return soup.points[p][axis] < low[axis];
        });
        const auto last = std::partition_point(first, points.end(), [&](std::uint32_t p) {
            return soup.points[p][axis] <= high[axis];
        });
        const std::span<const std::uint32_t> slab(first, last);
        if (slab.size() < fewest.size()) fewest = slab;
    }
    return fewest;
}

/// The open points inside the edge from a to b, from a to b.
PointIndices points_on_edge(const TriangleSoup& soup, const std::array<PointIndices, 3>& sorted,
                            std::pair<std::uint32_t, std::uint32_t> ends, double distance) {
    const Vec3& a = soup.points[ends.first];
    const Vec3& b = soup.points[ends.second];
    const Vec3 ab = b - a;
    const double length = ab.norm();
    const Vec3 margin = Vec3::Constant(distance);
    std::vector<std::pair<double, std::uint32_t>> found;
    for (const std::uint32_t point :
         candidates(soup, sorted, a.cwiseMin(b) - margin, a.cwiseMax(b) + margin)) {
        const Vec3 offset = soup.points[point] - a;
        const double along = offset.dot(ab) / length;
        if (along <= distance || along >= length - distance) continue;
        if ((offset - along / length * ab).norm() <= distance) found.emplace_back(along, point);
    }
    std::sort(found.begin(), found.end());
    PointIndices on_edge;
    for (const auto& [along, point] : found) on_edge.push_back(point);
    return on_edge;
}

/// Splits every triangle at one of its edges at most. Returns whether any was split.
bool split_once(TriangleSoup& soup, double distance, Finding& finding) {
    const std::vector<EdgeSide> edges = open_edges(soup);
    const std::array<PointIndices, 3> sorted = sorted_ends(soup, edges);
    const std::size_t before = soup.triangles.size();
    std::vector<bool> is_split(before, false);
    for (const EdgeSide& edge : edges) {
        const std::size_t triangle = edge.triangle();
        const std::size_t side = edge.side();
        if (is_split[triangle]) continue;
        const std::uint32_t a = soup.triangles[triangle][side];
        const std::uint32_t b = soup.triangles[triangle][(side + 1) % 3];
        const std::uint32_t tip = soup.triangles[triangle][(side + 2) % 3];
        PointIndices on_edge = points_on_edge(soup, sorted, {a, b}, distance);
        std::erase(on_edge, tip);
        if (on_edge.empty()) continue;
        if (finding.count == 0) finding.place = soup.points[on_edge.front()];
        finding.count += on_edge.size();
        is_split[triangle] = true;
        soup.triangles[triangle] = {a, on_edge.front(), tip};
        on_edge.push_back(b);
        for (std::size_t k = 1; k < on_edge.size(); ++k)
            soup.triangles.push_back({on_edge[k - 1], on_edge[k], tip});
    }
    return soup.triangles.size() > before;
}

}  // namespace

void split_at_t_junctions(TriangleSoup& soup, double distance, RepairReport& report) {
    Finding finding{.what = "corners on the edge of a neighbor", .treatment = "neighbor split"};
    // A triangle has three edges; each round leaves fewer points inside the open ones.
    for (int round = 0; round < 3 && split_once(soup, distance, finding); ++round) continue;
    report.add(finding);
}

}  // namespace dem::shapegen
