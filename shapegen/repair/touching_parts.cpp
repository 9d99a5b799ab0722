// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/touching_parts.hpp"

#include "shapegen/repair/edge_sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dem::shapegen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Sets of numbers that are joined pair by pair.
class Sets {
  public:
    explicit Sets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    void join(std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax({find(a), find(b)});
        parent_[high] = low;
    }

  private:
    std::vector<std::size_t> parent_;
};

/// A triangle that stands on an edge.
struct Leaf {
    EdgeSide side;
    Point tip;       ///< the corner opposite to the edge
    bool is_rising;  ///< passes the edge from its lower end to the higher
};

Point exact(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

Leaf leaf(const TriangleSoup& soup, const EdgeSide& side) {
    const auto& triangle = soup.triangles[side.triangle()];
    return {side, exact(soup.points[triangle[(side.side() + 2) % 3]]),
            triangle[side.side()] == side.low};
}

/// The angle of leaves around their edge, rising from a first one on. Compares exactly.
class AngleOrder {
  public:
    AngleOrder(const TriangleSoup& soup, const Leaf& first)
        : p_(exact(soup.points[first.side.low])),
          q_(exact(soup.points[first.side.high])),
          reference_(first.tip) {}

    bool operator()(const Leaf& a, const Leaf& b) const {
        const int half_a = half(a.tip);
        const int half_b = half(b.tip);
        if (half_a != half_b) return half_a < half_b;
        const auto turn = CGAL::orientation(p_, q_, a.tip, b.tip);
        if (turn != CGAL::COPLANAR) return turn == CGAL::POSITIVE;
        // In one place: the body that ends here comes before the one that begins.
        if (a.is_rising != b.is_rising) return a.is_rising;
        return a.side.corner < b.side.corner;
    }

  private:
    /// 0 in the half plane of the reference, 1 up to the opposite one, 2 there, 3 beyond.
    int half(const Point& r) const {
        const auto turn = CGAL::orientation(p_, q_, reference_, r);
        if (turn == CGAL::POSITIVE) return 1;
        if (turn == CGAL::NEGATIVE) return 3;
        return CGAL::coplanar_orientation(p_, q_, reference_, r) == CGAL::POSITIVE ? 0 : 2;
    }

    Point p_, q_, reference_;
};

using Pairs = std::vector<std::pair<EdgeSide, EdgeSide>>;

/// The leaves of an edge, two by two around a wedge of a body: the one behind which the inside
/// begins and the one before which it ends. Empty when they do not alternate.
Pairs wedges(const TriangleSoup& soup, std::vector<Leaf> leaves) {
    const auto is_falling = [](const Leaf& leaf) { return !leaf.is_rising; };
    const bool are_flat = std::any_of(leaves.begin(), leaves.end(), [&](const Leaf& leaf) {
        return CGAL::collinear(exact(soup.points[leaf.side.low]),
                               exact(soup.points[leaf.side.high]), leaf.tip);
    });
    // Behind a leaf that passes the edge falling, towards larger angles, lies its inside.
    const auto first = std::find_if(leaves.begin(), leaves.end(), is_falling);
    if (are_flat || first == leaves.end()) return {};
    std::sort(leaves.begin(), leaves.end(), AngleOrder(soup, Leaf(*first)));
    // Those that rise at the angle of the first belong to the end.
    std::rotate(leaves.begin(), std::find_if(leaves.begin(), leaves.end(), is_falling),
                leaves.end());
    Pairs pairs;
    for (std::size_t k = 0; k + 1 < leaves.size(); k += 2) {
        if (leaves[k].is_rising || !leaves[k + 1].is_rising) return {};
        pairs.emplace_back(leaves[k].side, leaves[k + 1].side);
    }
    return pairs;
}

/// Joins the corners that two sides of one edge share.
void join(const TriangleSoup& soup, Sets& corners, const EdgeSide& a, const EdgeSide& b) {
    const auto corner = [&soup](const EdgeSide& s, std::uint32_t end) {
        const bool begins_there = soup.triangles[s.triangle()][s.side()] == end;
        return 3 * s.triangle() + (s.side() + (begins_there ? 0 : 1)) % 3;
    };
    for (const std::uint32_t end : {a.low, a.high}) corners.join(corner(a, end), corner(b, end));
}

}  // namespace

void part_touching_bodies(TriangleSoup& soup, RepairReport& report) {
    const std::vector<EdgeSide> sides = sides_by_edge(soup);
    bool is_single = true;
    visit_edges(sides, [&](auto begin, auto end) {
        is_single &= end - begin <= 2 || (end - begin) % 2 == 1;
    });
    if (is_single) return;
    Sets corners(3 * soup.triangles.size());
    bool has_wedges = false;
    visit_edges(sides, [&](auto begin, auto end) {
        Pairs pairs;
        if (end - begin > 2 && (end - begin) % 2 == 0) {
            std::vector<Leaf> leaves;
            for (auto side = begin; side != end; ++side) leaves.push_back(leaf(soup, *side));
            pairs = wedges(soup, std::move(leaves));
            has_wedges |= !pairs.empty();
        }
        if (pairs.empty())
            for (auto side = begin; side != end; ++side) pairs.emplace_back(*begin, *side);
        for (const auto& [a, b] : pairs) join(soup, corners, a, b);
    });
    if (!has_wedges) return;
    Finding finding{.what = "points where surfaces meet in a corner or an edge",
                    .treatment = "split"};
    constexpr auto unset = ~std::uint32_t{0};
    std::vector<std::uint32_t> point_of(3 * soup.triangles.size(), unset);  // of each set
    std::vector<bool> is_taken(soup.points.size(), false);
    for (std::size_t c = 0; c < point_of.size(); ++c) {
        std::uint32_t& corner = soup.triangles[c / 3][c % 3];
        std::uint32_t& point = point_of[corners.find(c)];
        if (point == unset && !is_taken[corner]) {
            point = corner;
            is_taken[corner] = true;
        } else if (point == unset) {
            point = static_cast<std::uint32_t>(soup.points.size());
            if (finding.count++ == 0) finding.place = soup.points[corner];
            soup.points.push_back(Vec3(soup.points[corner]));
        }
        corner = point;
    }
    report.add(finding);
}

bool has_closed_parts(const TriangleSoup& soup) {
    const std::vector<EdgeSide> sides = sides_by_edge(soup);
    Sets triangles(soup.triangles.size());
    bool is_closed = !sides.empty();
    visit_edges(sides, [&](auto begin, auto end) {
        is_closed &=
            end - begin == 2 && leaf(soup, *begin).is_rising != leaf(soup, *(begin + 1)).is_rising;
        triangles.join(begin->triangle(), (end - 1)->triangle());
    });
    if (!is_closed) return false;
    std::size_t parts = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) parts += triangles.find(t) == t ? 1 : 0;
    return parts > 1;
}

}  // namespace dem::shapegen
