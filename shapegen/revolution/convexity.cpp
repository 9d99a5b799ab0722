// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/convexity.hpp"

#include <algorithm>
#include <vector>

namespace dem::shapegen {
namespace {

double side(const Vec2& a, const Vec2& b, const Vec2& x) {
    return (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
}

/// Points of the profile in its order: ends of the pieces, and inner points of the curved ones.
std::vector<Vec2> samples_of(const Profile& profile) {
    constexpr int parts = 16;
    std::vector<Vec2> points{profile.pieces().front().from};
    for (const ProfilePiece& piece : profile.pieces()) {
        for (int i = 1; piece.turn > 0.0 && i < parts; ++i) {
            const double t = piece.t0 + (piece.t1 - piece.t0) * i / parts;
            points.push_back(evaluate(profile.segments()[piece.segment], t).point);
        }
        points.push_back(piece.to);
    }
    return points;
}

/// The hull of points and their mirror images, right half, bottom to top (Andrew's chain by z).
std::vector<Vec2> right_hull(std::vector<Vec2> points) {
    std::stable_sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
        return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
    });
    // The hull runs straight from the axis to the outermost of the lowest and of the highest
    // points.
    points.insert(points.begin(), Vec2(0.0, points.front().y()));
    points.emplace_back(0.0, points.back().y());
    std::vector<Vec2> hull;
    for (const Vec2& point : points) {
        while (hull.size() > 1 && side(hull[hull.size() - 2], hull.back(), point) <= 0.0)
            hull.pop_back();
        hull.push_back(point);
    }
    return hull;
}

}  // namespace

Convexity convexity(const Profile& profile) {
    const std::vector<Vec2> points = samples_of(profile);
    const std::vector<Vec2> hull = right_hull(points);
    std::vector<ProfileSegment> edges;
    for (std::size_t i = 1; i < hull.size(); ++i)
        edges.emplace_back(LineSegment{hull[i - 1], hull[i]});
    const PieceTree tree(edges);
    Convexity result;
    for (const Vec2& point : points)
        result.hull_distance = std::max(result.hull_distance, tree.nearest(edges, point).distance);
    result.is_convex = result.hull_distance <= convexity_tolerance * profile.major_axis_length();
    return result;
}

}  // namespace dem::shapegen
