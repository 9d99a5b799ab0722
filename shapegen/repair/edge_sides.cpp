// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/edge_sides.hpp"

#include <algorithm>
#include <numeric>

namespace dem::shapegen {

std::vector<EdgeSide> sides_by_edge(const TriangleSoup& soup) {
    const auto visit_sides = [&soup](const auto& visit) {
        std::uint32_t corner = 0;
        for (const auto& triangle : soup.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = triangle[k];
                const std::uint32_t b = triangle[(k + 1) % 3];
                visit(EdgeSide{std::min(a, b), std::max(a, b), corner++});
            }
    };
    // By the lower end, in one pass; few sides have the same.
    std::vector<std::size_t> begin(soup.points.size() + 1, 0);
    visit_sides([&begin](const EdgeSide& side) { ++begin[side.low + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<EdgeSide> sides(3 * soup.triangles.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    visit_sides([&](const EdgeSide& side) { sides[next[side.low]++] = side; });
    for (std::size_t p = 0; p < soup.points.size(); ++p)
        std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[p]),
                  sides.begin() + static_cast<std::ptrdiff_t>(begin[p + 1]),
                  [](const EdgeSide& a, const EdgeSide& b) {
                      return a.high != b.high ? a.high < b.high : a.corner < b.corner;
                  });
    return sides;
}

}  // namespace dem::shapegen
