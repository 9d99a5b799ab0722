// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_hull.hpp"

#include "common/error.hpp"
#include "common/math/aabb.hpp"
#include "common/shapes/hull_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <unordered_map>

/// Quickhull: a tetrahedron grows by the farthest of the points outside of one of its triangles;
/// the triangles that see this point give way to the cone from it to their outline. Triangles in
/// one plane are joined to faces at the end (hull_faces.hpp).
namespace dem {

namespace {

using Index = std::uint32_t;

struct Triangle {
    std::array<Index, 3> v{};
    Vec3 normal = Vec3::Zero();
    double offset = 0.0;
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
        tolerance_ = 1e-11 * (box.upper - box.lower).norm();
        start();
        // Triangles that are added have points of their own, and come later in the list.
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (triangles_[t].is_alive && !triangles_[t].outside.empty()) add_farthest_of(t);
        }
    }

    std::vector<std::array<Index, 3>> triangles() const {
        std::vector<std::array<Index, 3>> result;
        for (const Triangle& t : triangles_)
            if (t.is_alive) result.push_back(t.v);
        return result;
    }

  private:
    std::size_t across(Index from, Index to) const { return triangle_of_.at(key(to, from)); }

    double height(const Triangle& t, Index p) const { return t.normal.dot(points_[p]) - t.offset; }

    std::size_t add(Index a, Index b, Index c) {
        Triangle t;
        t.v = {a, b, c};
        const Vec3 cross = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
        const double area = cross.norm();
        t.normal = area > 0.0 ? Vec3(cross / area) : Vec3::Zero();
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
            fail_flat_hull(points_.size());
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
    double tolerance_ = 0.0;
    std::vector<Triangle> triangles_;
    std::unordered_map<std::uint64_t, std::size_t> triangle_of_;  ///< by directed edge
};

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
    require_points_of_hull(points);
    return polyhedron_of(points, Quickhull(points).triangles());
}

ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth, const HullOfPoints& hull) {
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
    const ConvexPolyhedron polar = hull(dual);
    std::vector<Vec3> corners;
    for (std::size_t f = 0; f < polar.faces.size(); ++f) {
        const Vec3 m = polar.normal(f);
        corners.push_back(center + m / polar.offset(f, m));
    }
    return hull(corners);
}

ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth) {
    return eroded(solid, depth, convex_hull);
}

}  // namespace dem
