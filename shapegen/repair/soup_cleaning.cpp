// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/soup_cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace dem::shapegen {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

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

std::vector<std::uint32_t> open_points(const TriangleSoup& soup) {
    std::vector<std::uint32_t> points;
    for (const EdgeSide& side : open_edges(soup)) {
        points.push_back(side.low);
        points.push_back(side.high);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace

std::vector<EdgeSide> open_edges(const TriangleSoup& soup) {
    std::vector<EdgeSide> open;
    const std::vector<EdgeSide> sides = sides_by_edge(soup);
    visit_edges(sides, [&open](auto begin, auto end) {
        if (end - begin == 1) open.push_back(*begin);
    });
    return open;
}

void keep_triangles(TriangleSoup& soup, const std::vector<bool>& is_kept) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        if (is_kept[t]) soup.triangles[kept++] = soup.triangles[t];
    soup.triangles.resize(kept);
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
    Finding finding{.what = "triangles with two corners in one point", .treatment = "removed"};
    std::vector<bool> is_kept;
    is_kept.reserve(soup.triangles.size());
    for (const auto& [i, j, k] : soup.triangles) {
        is_kept.push_back(i != j && j != k && k != i);
        if (!is_kept.back() && finding.count++ == 0) finding.place = soup.points[i];
    }
    keep_triangles(soup, is_kept);
    report.add(finding);
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
    report.add(finding);
}

}  // namespace dem::shapegen
