// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/soup_cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace dem {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

bool is_before(const Vec3& a, const Vec3& b) {
    return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// Renumbers corners, then drops unused points; the others keep their order.
void renumber(TriangleSoup& soup, const std::vector<std::uint32_t>& new_name) {
    constexpr auto unused = ~std::uint32_t{0};
    std::vector<std::uint32_t> position(soup.points.size(), unused);
    for (Triangle& triangle : soup.triangles)
        for (std::uint32_t& corner : triangle) {
            corner = new_name[corner];
            position[corner] = 0;
        }
    std::uint32_t count = 0;
    for (std::size_t p = 0; p < soup.points.size(); ++p) {
        if (position[p] == unused) continue;
        position[p] = count;
        soup.points[count++] = soup.points[p];
    }
    soup.points.resize(count);
    for (Triangle& triangle : soup.triangles)
        for (std::uint32_t& corner : triangle) corner = position[corner];
}

/// Keeps the triangles of which `keep` is true, reports the others.
template <class Keep>
void filter(TriangleSoup& soup, const Keep& keep, Finding finding, RepairReport& report) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        if (keep(t)) {
            soup.triangles[kept++] = soup.triangles[t];
        } else if (finding.count++ == 0) {
            finding.place = soup.points[soup.triangles[t][0]];
        }
    }
    if (finding.count == 0) return;
    soup.triangles.resize(kept);
    report.findings.push_back(std::move(finding));
}

std::vector<std::uint32_t> open_points(const TriangleSoup& soup) {
    std::vector<std::uint32_t> points;
    for (const auto& [triangle, side] : open_edges(soup)) {
        points.push_back(soup.triangles[triangle][side]);
        points.push_back(soup.triangles[triangle][(side + 1) % 3]);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace

std::vector<SoupEdge> open_edges(const TriangleSoup& soup) {
    // Ends in rising order, then which triangle has them where.
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::size_t, std::size_t>> edges;
    edges.reserve(3 * soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t a = soup.triangles[t][side];
            const std::uint32_t b = soup.triangles[t][(side + 1) % 3];
            edges.emplace_back(std::min(a, b), std::max(a, b), t, side);
        }
    std::sort(edges.begin(), edges.end());
    const auto same_ends = [&edges](std::size_t e, std::size_t f) {
        return std::get<0>(edges[e]) == std::get<0>(edges[f]) &&
               std::get<1>(edges[e]) == std::get<1>(edges[f]);
    };
    std::vector<SoupEdge> open;
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first + 1;
        while (end < edges.size() && same_ends(first, end)) ++end;
        if (end - first == 1)
            open.push_back({std::get<2>(edges[first]), std::get<3>(edges[first])});
        first = end;
    }
    return open;
}

void share_points(TriangleSoup& soup) {
    std::vector<std::uint32_t> order(soup.points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&soup](std::uint32_t a, std::uint32_t b) {
        if (soup.points[a] == soup.points[b]) return a < b;
        return is_before(soup.points[a], soup.points[b]);
    });
    std::vector<std::uint32_t> first_equal(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool is_repeated = k > 0 && soup.points[order[k]] == soup.points[order[k - 1]];
        first_equal[order[k]] = is_repeated ? first_equal[order[k - 1]] : order[k];
    }
    renumber(soup, first_equal);
}

void remove_collapsed(TriangleSoup& soup, RepairReport& report) {
    const auto keep = [&soup](std::size_t t) {
        const auto& [i, j, k] = soup.triangles[t];
        return i != j && j != k && k != i;
    };
    filter(soup, keep, {.what = "triangles with two corners in one point", .treatment = "removed"},
           report);
}

void remove_duplicates(TriangleSoup& soup, RepairReport& report) {
    // Sorted corners, whether the triangle turns like them, its index.
    std::vector<std::tuple<Triangle, bool, std::size_t>> sorted;
    sorted.reserve(soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const Triangle& corners = soup.triangles[t];
        Triangle key = corners;
        std::sort(key.begin(), key.end());
        const auto start = std::find(corners.begin(), corners.end(), key[0]) - corners.begin();
        const bool is_even = corners[static_cast<std::size_t>(start + 1) % 3] == key[1];
        sorted.emplace_back(key, is_even, t);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> is_kept(soup.triangles.size(), false);
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t end = first;
        std::size_t odd = 0;
        while (end < sorted.size() && std::get<0>(sorted[end]) == std::get<0>(sorted[first]))
            odd += std::get<1>(sorted[end++]) ? 0 : 1;
        const std::size_t even = end - first - odd;  // sorted after the odd ones
        if (odd > even) is_kept[std::get<2>(sorted[first])] = true;
        if (even > odd) is_kept[std::get<2>(sorted[first + odd])] = true;
        first = end;
    }
    const auto keep = [&is_kept](std::size_t t) { return is_kept[t]; };
    filter(soup, keep, {.what = "duplicate triangles", .treatment = "removed"}, report);
}

void close_cracks(TriangleSoup& soup, double distance, RepairReport& report) {
    using Cell = std::array<std::int64_t, 3>;
    const std::vector<std::uint32_t> open = open_points(soup);
    if (open.empty()) return;
    const auto cell_of = [&](const Vec3& p) {
        return Cell{static_cast<std::int64_t>(std::floor(p.x() / distance)),
                    static_cast<std::int64_t>(std::floor(p.y() / distance)),
                    static_cast<std::int64_t>(std::floor(p.z() / distance))};
    };
    std::map<Cell, std::vector<std::uint32_t>> kept;  // points that others may be merged into
    std::vector<std::uint32_t> new_name(soup.points.size());
    std::iota(new_name.begin(), new_name.end(), 0U);
    Finding finding{.what = "points at cracks", .treatment = "merged with their neighbors"};
    const auto near_kept = [&](std::uint32_t point) {
        const Cell cell = cell_of(soup.points[point]);
        for (int n = 0; n < 27; ++n) {
            const auto found =
                kept.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
            if (found == kept.end()) continue;
            for (const std::uint32_t other : found->second)
                if ((soup.points[other] - soup.points[point]).norm() <= distance) return other;
        }
        return point;
    };
    for (const std::uint32_t point : open) {
        new_name[point] = near_kept(point);
        if (new_name[point] == point) {
            kept[cell_of(soup.points[point])].push_back(point);
        } else if (finding.count++ == 0) {
            finding.place = soup.points[point];
        }
    }
    if (finding.count == 0) return;
    renumber(soup, new_name);
    report.findings.push_back(finding);
}

}  // namespace dem
