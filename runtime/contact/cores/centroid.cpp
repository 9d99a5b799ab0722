// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/centroid.hpp"

#include "runtime/contact/cores/round_features.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

using Polygon = std::vector<Vec2>;

double cross(const Vec2& u, const Vec2& v) {
    return u.x() * v.y() - u.y() * v.x();
}

/// Corners of the convex hull, anticlockwise (Andrew's monotone chain).
Polygon hull(Polygon& points) {
    std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) {
        return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    });
    if (points.size() < 3) return points;
    Polygon corners;
    const auto add = [&](const Vec2& p, std::size_t least) {
        while (corners.size() >= least + 2 &&
               cross(corners.back() - corners[corners.size() - 2], p - corners.back()) <= 0.0)
            corners.pop_back();
        corners.push_back(p);
    };
    for (const Vec2& p : points) add(p, 0);
    const std::size_t lower = corners.size() - 1;
    for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], lower);
    corners.pop_back();
    return corners;
}

/// The part of a polygon to the left of the line a -> b (Sutherland and Hodgman).
Polygon left_part(const Polygon& polygon, const Vec2& a, const Vec2& b) {
    Polygon part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& p = polygon[k];
        const Vec2& q = polygon[(k + 1) % polygon.size()];
        const double of_p = cross(b - a, p - a);
        const double of_q = cross(b - a, q - a);
        if (of_p >= 0.0) part.push_back(p);
        if ((of_p > 0.0 && of_q < 0.0) || (of_p < 0.0 && of_q > 0.0))
            part.push_back(p + of_p / (of_p - of_q) * (q - p));
    }
    return part;
}

/// Midpoint of the two points farthest apart.
Vec2 middle(const Polygon& points) {
    Vec2 center = points[0];
    double most = 0.0;
    for (const Vec2& p : points) {
        for (const Vec2& q : points) {
            if ((p - q).squaredNorm() <= most) continue;
            most = (p - q).squaredNorm();
            center = 0.5 * (p + q);
        }
    }
    return center;
}

Vec2 centroid_of(const Polygon& polygon) {
    double area = 0.0;
    double extent2 = 0.0;
    Vec2 moment = Vec2::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec2 u = polygon[k] - polygon[0];
        const Vec2 v = polygon[k + 1] - polygon[0];
        const double part = cross(u, v);
        area += part;
        moment += part * (u + v);
        extent2 = std::max({extent2, u.squaredNorm(), v.squaredNorm()});
    }
    if (!(area > 1e-12 * extent2)) return middle(polygon);
    return polygon[0] + moment / (3.0 * area);
}

/// Two segments: the middle of what they share where they lie along each other.
bool segments_centroid(const Polygon& a, const Polygon& b, Vec2& centroid) {
    const Vec2 way = a[1] - a[0];
    const double length = way.norm();
    const Vec2 other = b[1] - b[0];
    constexpr double parallel_sine = 1e-3;
    if (std::abs(cross(way, other)) > parallel_sine * length * other.norm()) return false;
    const Vec2 along = way / length;
    const double from = std::min(along.dot(b[0] - a[0]), along.dot(b[1] - a[0]));
    const double to = std::max(along.dot(b[0] - a[0]), along.dot(b[1] - a[0]));
    if (to < 0.0 || from > length) return false;
    centroid = a[0] + 0.5 * (std::max(from, 0.0) + std::min(to, length)) * along;
    return true;
}

/// The points of a core less than `depth` behind its farthest along `towards`, as [GC] takes them:
/// vertices, of circles points on the rim, of smooth parts the farthest point.
void list_points(const PlacedCore& core, const Vec3& towards, double depth, std::uint32_t start,
                 ConvexCap& cap, std::vector<Vec3>& points) {
    points.clear();
    if (core.has_vertices()) {
        collect_vertices(core, towards, depth, start, cap);
        for (const ConvexCap::Vertex& v : cap.vertices) points.push_back(core.vertex(v.number));
        return;
    }
    const Vec3 farthest = core.support(towards, 0).position;
    const double least = farthest.dot(towards) - depth;
    const auto add = [&](const Vec3& x) {
        if (x.dot(towards) > least) points.push_back(x);
    };
    const PlacedCaps caps = caps_of(core);
    for (std::size_t k = 0; k < caps.count; ++k) {
        add(caps.cap[k].support(towards, 0).position);
        for (std::size_t n = 0; n < PlacedCap::sample_count; ++n) add(caps.cap[k].sample(n));
    }
    if (points.empty()) points.push_back(farthest);
}

}  // namespace

bool common_centroid(Polygon& a, Polygon& b, Vec2& centroid) {
    const Polygon hull_a = hull(a);
    const Polygon hull_b = hull(b);
    if (hull_a.size() == 2 && hull_b.size() == 2)
        return segments_centroid(hull_a, hull_b, centroid);
    const bool swap = hull_b.size() < 3;
    const Polygon& by = swap ? hull_a : hull_b;
    Polygon common = swap ? hull_b : hull_a;
    if (by.size() < 3) return false;
    for (std::size_t k = 0; k < by.size() && !common.empty(); ++k)
        common = left_part(common, by[k], by[(k + 1) % by.size()]);
    if (common.empty()) return false;
    centroid = centroid_of(common);
    return true;
}

FeaturePoint patch_centroid(const PlacedCore& i, const PlacedCore& j, const FeaturePoint& deepest,
                            const NearCores& near, ConvexScratch& scratch) {
    const Vec3& n = near.normal;
    const Vec3 e1 = n.unitOrthogonal();
    const Vec3 e2 = n.cross(e1);
    const auto seen = [&](const PlacedCore& core, const Vec3& towards, std::uint32_t start,
                          ConvexCap& cap, Polygon& polygon) {
        list_points(core, towards, near.deepest, start, cap, scratch.corners);
        polygon.clear();
        for (const Vec3& x : scratch.corners) polygon.emplace_back(x.dot(e1), x.dot(e2));
    };
    seen(i, -n, near.i.vertex[0], scratch.i, scratch.polygon_i);
    seen(j, n, near.j.vertex[0], scratch.j, scratch.polygon_j);
    Vec2 center;
    if (!common_centroid(scratch.polygon_i, scratch.polygon_j, center)) return deepest;
    FeaturePoint p = deepest;
    p.position = center.x() * e1 + center.y() * e2 + deepest.position.dot(n) * n;
    return p;
}

}  // namespace dem::runtime
