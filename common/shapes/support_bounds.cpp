// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/support_bounds.hpp"

#include "common/shapes/support_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

namespace {

/// A support point of the profile.
struct Sample {
    Vec2 normal;   ///< unit
    Vec2 point;    ///< [m]
    double reach;  ///< radius of curvature times the way to the end of the piece (ball_slope) [m]
};

Vec2 direction_of(double q) {
    return Vec2(1.0 - std::abs(q), q).normalized();
}

std::vector<Sample> samples(const SupportMap& map) {
    const std::size_t count = map.pieces.size();
    const std::size_t parts = 64 / count + 3;
    std::vector<Sample> all;
    double low = -1.0;
    for (std::size_t k = 0; k < count; ++k) {
        const double high = map.piece_end[k];
        const SupportPiece& p = map.pieces[k];
        for (std::size_t m = 0; m <= parts; ++m) {
            const double q =
                low + (high - low) * static_cast<double>(m) / static_cast<double>(parts);
            const Vec2 n = direction_of(q);
            const Vec2 stretched(p.a * n.x(), p.b * n.y());
            const double length = stretched.norm();
            Sample s{n, {p.center_r, p.center_z}, 0.0};
            if (length > 0.0) {
                s.point += stretched.cwiseProduct(Vec2(p.a, p.b)) / length;
                double room = 1.0;
                if (k > 0) room = std::min(room, q - low);
                if (k + 1 < count) room = std::min(room, high - q);
                s.reach = square(p.a * p.b) / cube(length) * room;
            }
            all.push_back(s);
        }
        low = high;
    }
    return all;
}

/// Radius of the largest ball inside of the body that touches it at a sample. A ball of radius R
/// lies inside when for every normal m at an angle theta from n, the tangent plane of m is at least
/// R (1 - cos theta) beyond the point; across the meridian, where r >= R n_r.
double largest_ball(const Sample& at, const std::vector<Sample>& all) {
    double radius = at.normal.x() > 1e-12 ? at.point.x() / at.normal.x()
                                          : std::numeric_limits<double>::infinity();
    for (const Sample& other : all) {
        const double turn = 1.0 - at.normal.dot(other.normal);
        if (turn < 1e-13) continue;
        radius = std::min(radius, other.normal.dot(other.point - at.point) / turn);
    }
    return std::max(radius, 0.0);
}

}  // namespace

SupportBounds support_bounds(const SupportMap& map) {
    SupportBounds bounds;
    bounds.longest_radius = longest_radius(map);
    bounds.shortest_radius = std::numeric_limits<double>::infinity();
    for (const SupportPiece& p : map.pieces)
        bounds.shortest_radius = std::min(bounds.shortest_radius, shortest_radius(p));
    const std::vector<Sample> all = samples(map);
    bounds.inner_radius = std::numeric_limits<double>::infinity();
    for (const Sample& s : all)
        bounds.inner_radius = std::min(bounds.inner_radius, s.normal.dot(s.point));
    bounds.ball_slope = 1.0;
    for (const Sample& s : all) {
        if (s.reach > 1e-9 * bounds.inner_radius)
            bounds.ball_slope = std::min(bounds.ball_slope, largest_ball(s, all) / s.reach);
    }
    // What the samples may have missed between them.
    bounds.ball_slope *= 0.8;
    bounds.inner_radius *= 0.99;
    return bounds;
}

}  // namespace dem
