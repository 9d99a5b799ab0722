// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/solids/hull_faces.hpp"

#include "common/error.hpp"
#include "common/math/aabb.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace dem::shapegen {

namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;

constexpr Index none = ~Index{0};

/// The triangles of a hull with their planes and neighbors.
class Surface {
  public:
    Surface(std::span<const Vec3> points, std::span<const Corners> triangles)
        : points_(points), corners_(triangles) {
        Aabb box;
        for (const Vec3& p : points) box.extend(p);
        extent_ = (box.upper - box.lower).norm();
        for (std::size_t t = 0; t < size(); ++t) {
            const auto& [a, b, c] = corners_[t];
            const Vec3 cross = (points[b] - points[a]).cross(points[c] - points[a]);
            areas_.push_back(cross.norm());
            normals_.push_back(areas_[t] > 0.0 ? Vec3(cross / areas_[t]) : Vec3::Zero());
            triangle_of_[key(a, b)] = triangle_of_[key(b, c)] = triangle_of_[key(c, a)] = t;
        }
    }

    /// What counts as flat from now on, as part of the extent.
    void set_tolerance(double flat) { tolerance_ = flat * extent_; }

    std::size_t size() const { return corners_.size(); }
    const Corners& corners(std::size_t t) const { return corners_[t]; }
    double area(std::size_t t) const { return areas_[t]; }
    std::size_t across(Index from, Index to) const { return triangle_of_.at(key(to, from)); }

    bool is_in_plane(std::size_t other, std::size_t t) const {
        const double offset = normals_[t].dot(points_[corners_[t][0]]);
        return std::all_of(corners_[other].begin(), corners_[other].end(), [&](Index p) {
            return std::abs(normals_[t].dot(points_[p]) - offset) <= tolerance_;
        });
    }

    /// So low that its normal is one of rounding errors.
    bool is_thin(std::size_t t) const { return areas_[t] <= tolerance_ * length(longest_edge(t)); }

    std::array<Index, 2> longest_edge(std::size_t t) const {
        const auto& [a, b, c] = corners_[t];
        std::array<Index, 2> longest{a, b};
        for (const auto& edge : {std::array{b, c}, std::array{c, a}})
            if (length(edge) > length(longest)) longest = edge;
        return longest;
    }

    /// Whether a corner of an outline lies farther inside it than what counts as flat.
    bool is_bent(const std::vector<Index>& outline) const {
        const auto corner = [&](std::size_t k) { return points_[outline[k % outline.size()]]; };
        Vec3 normal = Vec3::Zero();
        for (std::size_t k = 1; k + 1 < outline.size(); ++k)
            normal += (corner(k) - corner(0)).cross(corner(k + 1) - corner(0));
        normal.normalize();
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Vec3 along = corner(k + 2) - corner(k);
            const double turn = normal.dot((corner(k + 1) - corner(k)).cross(along));
            if (turn < -tolerance_ * along.norm()) return true;
        }
        return false;
    }

  private:
    static std::uint64_t key(Index from, Index to) { return std::uint64_t{from} << 32 | to; }
    double length(const std::array<Index, 2>& edge) const {
        return (points_[edge[1]] - points_[edge[0]]).norm();
    }

    std::span<const Vec3> points_;
    std::span<const Corners> corners_;
    double extent_ = 0.0, tolerance_ = 0.0;  ///< [m]
    std::vector<double> areas_;              ///< twice [m^2]
    std::vector<Vec3> normals_;
    std::unordered_map<std::uint64_t, std::size_t> triangle_of_;  ///< by directed edge
};

/// Thin triangles that are left: to the face along their longest edge, from one to the next.
void give_thin_ones_away(const Surface& surface, std::vector<Index>& face) {
    for (bool is_any_given = true; is_any_given;) {
        is_any_given = false;
        for (std::size_t t = 0; t < surface.size(); ++t) {
            if (face[t] != none) continue;
            const auto [from, to] = surface.longest_edge(t);
            face[t] = face[surface.across(from, to)];
            is_any_given |= face[t] != none;
        }
    }
}

/// Number of the face of every triangle: the largest triangle left takes its neighbors that lie in
/// its plane, but for those that are to be alone.
std::vector<Index> joined(const Surface& surface, const std::vector<bool>& is_alone) {
    std::vector<Index> face(surface.size(), none);
    std::vector<std::size_t> order(surface.size());
    for (std::size_t t = 0; t < surface.size(); ++t) order[t] = t;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return surface.area(a) > surface.area(b);
    });
    Index count = 0;
    for (const std::size_t seed : order) {
        if (face[seed] != none || surface.is_thin(seed)) continue;
        std::vector<std::size_t> stack{seed};
        face[seed] = count;
        while (!stack.empty()) {
            const Corners& v = surface.corners(stack.back());
            stack.pop_back();
            for (std::size_t e = 0; e < 3; ++e) {
                const std::size_t other = surface.across(v[e], v[(e + 1) % 3]);
                if (face[other] != none || is_alone[seed] || is_alone[other] ||
                    !surface.is_in_plane(other, seed))
                    continue;
                face[other] = count;
                stack.push_back(other);
            }
        }
        ++count;
    }
    give_thin_ones_away(surface, face);
    return face;
}

/// The outline of every face as a closed walk over points; none where one has holes or meets
/// itself.
std::optional<std::vector<std::vector<Index>>> outlines(const Surface& surface,
                                                        const std::vector<Index>& face) {
    std::map<Index, std::map<Index, Index>> next;  // of a face: point -> point
    for (std::size_t t = 0; t < surface.size(); ++t) {
        const Corners& v = surface.corners(t);
        for (std::size_t e = 0; e < 3; ++e) {
            const Index from = v[e];
            const Index to = v[(e + 1) % 3];
            if (face[surface.across(from, to)] == face[t]) continue;
            if (!next[face[t]].emplace(from, to).second) return std::nullopt;
        }
    }
    std::vector<std::vector<Index>> result;
    for (const auto& [index, walk] : next) {
        std::vector<Index> outline;
        Index p = walk.begin()->first;
        do {
            outline.push_back(p);
            const auto step = walk.find(p);
            if (step == walk.end() || outline.size() > walk.size()) return std::nullopt;
            p = step->second;
        } while (p != outline.front());
        if (outline.size() != walk.size()) return std::nullopt;
        result.push_back(std::move(outline));
    }
    return result;
}

std::optional<ConvexPolyhedron> assembled(const std::vector<std::vector<Index>>& faces,
                                          std::span<const Vec3> points) {
    // A point with two faces lies on an edge between others.
    std::vector<Index> uses(points.size());
    for (const auto& f : faces)
        for (const Index p : f) ++uses[p];
    ConvexPolyhedron result;
    std::vector<Index> number(points.size());
    for (Index p = 0; p < points.size(); ++p) {
        if (uses[p] < 3) continue;
        number[p] = static_cast<Index>(result.vertices.size());
        result.vertices.push_back(points[p]);
    }
    for (const auto& f : faces) {
        std::vector<Index> kept;
        for (const Index p : f)
            if (uses[p] >= 3) kept.push_back(number[p]);
        if (kept.size() < 3) return std::nullopt;
        std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end()), kept.end());
        result.faces.push_back(std::move(kept));
    }
    std::sort(result.faces.begin(), result.faces.end());
    std::size_t corners = 0;
    for (const auto& f : result.faces) corners += f.size();
    // Euler: V - E + F = 2.
    if (result.vertices.size() + result.faces.size() != corners / 2 + 2) return std::nullopt;
    return result;
}

}  // namespace

void require_points_of_hull(std::span<const Vec3> points) {
    if (points.size() < 4) {
        throw Error("convex hull", std::to_string(points.size()) +
                                       " points, expected at least four that span a solid");
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].allFinite())
            throw Error("convex hull",
                        "point " + std::to_string(k) + " is not finite, expected numbers");
    }
}

void fail_flat_hull(std::size_t points) {
    throw Error("convex hull",
                "all " + std::to_string(points) + " points lie in one plane, expected a solid");
}

namespace {

/// The faces of a surface, all of them convex; none where outlines have holes or the faces make no
/// solid.
std::optional<ConvexPolyhedron> solid_of(const Surface& surface, std::span<const Vec3> points) {
    std::vector<bool> is_alone(surface.size());
    for (;;) {
        const std::vector<Index> face = joined(surface, is_alone);
        const auto faces = outlines(surface, face);
        if (!faces || faces->size() < 4) return std::nullopt;
        // Where points lie by about the tolerance beside a plane, some of its triangles join and
        // others do not: what they make is any polygon.
        bool is_any_bent = false;
        for (std::size_t t = 0; t < surface.size(); ++t) {
            if (is_alone[t] || face[t] == none || !surface.is_bent((*faces)[face[t]])) continue;
            is_alone[t] = is_any_bent = true;
        }
        if (!is_any_bent) return assembled(*faces, points);
    }
}

}  // namespace

ConvexPolyhedron polyhedron_of(std::span<const Vec3> points, std::span<const Corners> triangles) {
    Surface surface(points, triangles);
    // Where points lie by just the tolerance beside a plane, parts of it may join around others.
    for (const double flat : {1e-9, 1e-10, 1e-11}) {
        surface.set_tolerance(flat);
        if (auto solid = solid_of(surface, points)) return std::move(*solid);
    }
    throw Error("convex hull",
                "the points are too nearly in one plane or one line to tell the faces of their "
                "hull apart, expected a solid with less than 1e8 times its thickness in length");
}

}  // namespace dem::shapegen
