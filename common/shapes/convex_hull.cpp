// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_hull.hpp"

#include "common/error.hpp"
#include "common/math/aabb.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <unordered_map>

/// Quickhull: a tetrahedron grows by the farthest of the points outside of one of its triangles;
/// the triangles that see this point give way to the cone from it to their outline. Triangles in
/// one plane are joined to faces at the end.
namespace dem {

namespace {

using Index = std::uint32_t;

struct Triangle {
    std::array<Index, 3> v{};
    Vec3 normal = Vec3::Zero();
    double offset = 0.0;
    double area = 0.0;
    std::vector<Index> outside;  ///< points above it that no earlier triangle took
    bool is_alive = true;
};

std::uint64_t key(Index from, Index to) {
    return std::uint64_t{from} << 32 | to;
}

class Quickhull {
  public:
    explicit Quickhull(std::span<const Vec3> points) : points_(points) {
        Aabb box;
        for (const Vec3& p : points) box.extend(p);
        extent_ = (box.upper - box.lower).norm();
        tolerance_ = 1e-11 * extent_;
        start();
        // Triangles that are added have points of their own, and come later in the list.
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (triangles_[t].is_alive && !triangles_[t].outside.empty()) add_farthest_of(t);
        }
    }

    const std::vector<Triangle>& triangles() const { return triangles_; }
    double extent() const { return extent_; }

    std::size_t across(Index from, Index to) const { return triangle_of_.at(key(to, from)); }

  private:
    double height(const Triangle& t, Index p) const { return t.normal.dot(points_[p]) - t.offset; }

    std::size_t add(Index a, Index b, Index c) {
        Triangle t;
        t.v = {a, b, c};
        const Vec3 cross = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
        t.area = cross.norm();
        t.normal = t.area > 0.0 ? Vec3(cross / t.area) : Vec3::Zero();
        t.offset = t.normal.dot(points_[a]);
        const std::size_t index = triangles_.size();
        triangles_.push_back(std::move(t));
        triangle_of_[key(a, b)] = triangle_of_[key(b, c)] = triangle_of_[key(c, a)] = index;
        return index;
    }

    template <class Measure>
    Index farthest(const Measure& measure) const {
        Index best = 0;
        double most = -std::numeric_limits<double>::infinity();
        for (Index k = 0; k < points_.size(); ++k) {
            const double m = measure(points_[k]);
            if (m > most) {
                most = m;
                best = k;
            }
        }
        return best;
    }

    void start() {
        const Index a = farthest([&](const Vec3& p) { return -p.x(); });
        const Vec3 pa = points_[a];
        const Index b = farthest([&](const Vec3& p) { return (p - pa).squaredNorm(); });
        const Vec3 along = (points_[b] - pa).normalized();
        const Index c = farthest([&](const Vec3& p) { return along.cross(p - pa).squaredNorm(); });
        const Vec3 normal = along.cross(points_[c] - pa).normalized();
        const Index d = farthest([&](const Vec3& p) { return std::abs(normal.dot(p - pa)); });
        const double height_d = normal.dot(points_[d] - pa);
        if (!(along.cross(points_[c] - pa).norm() > 1e3 * tolerance_) ||
            !(std::abs(height_d) > 1e3 * tolerance_)) {
            throw Error("convex hull", "all " + std::to_string(points_.size()) +
                                           " points lie in one plane, expected a solid");
        }
        if (height_d > 0.0) {
            add(a, c, b), add(a, b, d), add(b, c, d), add(c, a, d);
        } else {
            add(a, b, c), add(b, a, d), add(c, b, d), add(a, c, d);
        }
        for (Index p = 0; p < points_.size(); ++p) give(p, 0);
    }

    /// To the first triangle from `first` on that the point is above.
    void give(Index p, std::size_t first) {
        for (std::size_t t = first; t < triangles_.size(); ++t) {
            if (triangles_[t].is_alive && height(triangles_[t], p) > tolerance_) {
                triangles_[t].outside.push_back(p);
                return;
            }
        }
    }

    void add_farthest_of(std::size_t t) {
        const auto& outside = triangles_[t].outside;
        const Index apex = *std::max_element(outside.begin(), outside.end(), [&](Index p, Index q) {
            return height(triangles_[t], p) < height(triangles_[t], q);
        });
        std::vector<std::size_t> visible{t};
        std::vector<std::array<Index, 2>> outline;
        triangles_[t].is_alive = false;
        for (std::size_t k = 0; k < visible.size(); ++k) {
            const std::array<Index, 3> v = triangles_[visible[k]].v;
            for (std::size_t e = 0; e < 3; ++e) {
                const Index from = v[e];
                const Index to = v[(e + 1) % 3];
                const std::size_t other = across(from, to);
                if (!triangles_[other].is_alive) continue;
                if (height(triangles_[other], apex) > tolerance_) {
                    triangles_[other].is_alive = false;
                    visible.push_back(other);
                }
            }
        }
        for (const std::size_t k : visible) {
            const std::array<Index, 3> v = triangles_[k].v;
            for (std::size_t e = 0; e < 3; ++e) {
                const Index from = v[e];
                const Index to = v[(e + 1) % 3];
                if (triangles_[across(from, to)].is_alive) outline.push_back({from, to});
            }
        }
        const std::size_t first = triangles_.size();
        for (const auto& [from, to] : outline) add(from, to, apex);
        for (const std::size_t k : visible) {
            const std::vector<Index> orphans = std::move(triangles_[k].outside);
            triangles_[k].outside.clear();
            for (const Index p : orphans)
                if (p != apex) give(p, first);
        }
    }

    std::span<const Vec3> points_;
    double extent_ = 0.0, tolerance_ = 0.0;
    std::vector<Triangle> triangles_;
    std::unordered_map<std::uint64_t, std::size_t> triangle_of_;  ///< by directed edge
};

/// Number of the face of every triangle: the largest triangle left takes its neighbors that lie in
/// its plane.
std::vector<Index> joined(const Quickhull& hull, std::span<const Vec3> points) {
    const auto& triangles = hull.triangles();
    constexpr Index none = ~Index{0};
    std::vector<Index> face(triangles.size(), none);
    std::vector<std::size_t> order;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (triangles[t].is_alive) order.push_back(t);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return triangles[a].area > triangles[b].area;
    });
    const double flat = 1e-9 * hull.extent();
    Index count = 0;
    for (const std::size_t seed : order) {
        if (face[seed] != none) continue;
        const Triangle& plane = triangles[seed];
        std::vector<std::size_t> stack{seed};
        face[seed] = count;
        while (!stack.empty()) {
            const auto v = triangles[stack.back()].v;
            stack.pop_back();
            for (std::size_t e = 0; e < 3; ++e) {
                const std::size_t other = hull.across(v[e], v[(e + 1) % 3]);
                if (face[other] != none) continue;
                const auto& w = triangles[other].v;
                const bool in_plane = std::all_of(w.begin(), w.end(), [&](Index p) {
                    return std::abs(plane.normal.dot(points[p]) - plane.offset) <= flat;
                });
                if (!in_plane) continue;
                face[other] = count;
                stack.push_back(other);
            }
        }
        ++count;
    }
    return face;
}

[[noreturn]] void fail_degenerate() {
    throw Error("convex hull",
                "the points are too nearly in one plane or one line to tell the faces of their "
                "hull apart, expected a solid with less than 1e8 times its thickness in length");
}

/// The outline of every face as a closed walk over points.
std::vector<std::vector<Index>> outlines(const Quickhull& hull, const std::vector<Index>& face) {
    std::map<Index, std::map<Index, Index>> next;  // of a face: point -> point
    const auto& triangles = hull.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!triangles[t].is_alive) continue;
        const auto& v = triangles[t].v;
        for (std::size_t e = 0; e < 3; ++e) {
            const Index from = v[e];
            const Index to = v[(e + 1) % 3];
            if (face[hull.across(from, to)] == face[t]) continue;
            if (!next[face[t]].emplace(from, to).second) fail_degenerate();
        }
    }
    std::vector<std::vector<Index>> result;
    for (const auto& [index, walk] : next) {
        std::vector<Index> outline;
        Index p = walk.begin()->first;
        do {
            outline.push_back(p);
            const auto step = walk.find(p);
            if (step == walk.end() || outline.size() > walk.size()) fail_degenerate();
            p = step->second;
        } while (p != outline.front());
        if (outline.size() != walk.size()) fail_degenerate();
        result.push_back(std::move(outline));
    }
    return result;
}

ConvexPolyhedron assembled(const std::vector<std::vector<Index>>& faces,
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
        if (kept.size() < 3) fail_degenerate();
        std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end()), kept.end());
        result.faces.push_back(std::move(kept));
    }
    std::sort(result.faces.begin(), result.faces.end());
    std::size_t corners = 0;
    for (const auto& f : result.faces) corners += f.size();
    // Euler: V - E + F = 2.
    if (result.vertices.size() + result.faces.size() != corners / 2 + 2) fail_degenerate();
    return result;
}

}  // namespace

Vec3 ConvexPolyhedron::normal(std::size_t face) const {
    // Newell's sum over the outline: no corner matters more than its size.
    const auto& f = faces[face];
    Vec3 sum = Vec3::Zero();
    const Vec3& origin = vertices[f[0]];
    for (std::size_t k = 1; k + 1 < f.size(); ++k)
        sum += (vertices[f[k]] - origin).cross(vertices[f[k + 1]] - origin);
    return sum.normalized();
}

double ConvexPolyhedron::offset(std::size_t face, const Vec3& n) const {
    double most = n.dot(vertices[faces[face][0]]);
    for (const Index p : faces[face]) most = std::max(most, n.dot(vertices[p]));
    return most;
}

ConvexPolyhedron convex_hull(std::span<const Vec3> points) {
    if (points.size() < 4) {
        throw Error("convex hull", std::to_string(points.size()) +
                                       " points, expected at least four that span a solid");
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].allFinite())
            throw Error("convex hull", "point " + std::to_string(k) + " is not finite");
    }
    const Quickhull hull(points);
    return assembled(outlines(hull, joined(hull, points)), points);
}

ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth) {
    if (depth == 0.0) return solid;
    Vec3 center = Vec3::Zero();
    for (const Vec3& v : solid.vertices) center += v;
    center /= static_cast<double>(solid.vertices.size());
    // Polar dual about the center: planes n . x = c become points n / c, and back.
    std::vector<Vec3> dual;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        const Vec3 n = solid.normal(f);
        const double distance = solid.offset(f, n) - n.dot(center);
        least = std::min(least, distance);
        dual.push_back(n / (distance - depth));
    }
    if (!(least > depth)) {
        std::ostringstream message;
        message << "rounding radius " << depth << " m, expected less than " << least
                << " m, the distance from the center to the nearest face";
        throw Error("convex shape", message.str());
    }
    const ConvexPolyhedron polar = convex_hull(dual);
    std::vector<Vec3> corners;
    for (std::size_t f = 0; f < polar.faces.size(); ++f) {
        const Vec3 m = polar.normal(f);
        corners.push_back(center + m / polar.offset(f, m));
    }
    return convex_hull(corners);
}

}  // namespace dem
