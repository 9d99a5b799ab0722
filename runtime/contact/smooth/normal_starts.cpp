// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/normal_starts.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// One half of a profile in space.
struct Meridian {
    const SupportMap& map;
    Vec3 outward, axis;
    double sign;

    bool has(int k) const { return k >= 0 && k < static_cast<int>(map.pieces.size()); }
    const SupportPiece& piece(int k) const { return map.pieces[static_cast<std::size_t>(k)]; }
    double low(int k) const {
        return k == 0 ? -1.0 : map.piece_end[static_cast<std::size_t>(k) - 1];
    }
    double high(int k) const { return map.piece_end[static_cast<std::size_t>(k)]; }
    bool is_edge(int k) const { return longest_radius(piece(k)) == 0.0; }
    double length(int k) const { return shortest_radius(piece(k)) * (high(k) - low(k)); }
    Vec3 direction(double q) const {
        const Vec2 n = Vec2(1.0 - std::abs(q), q).normalized();
        return sign * (n.x() * outward + n.y() * axis);
    }
    Vec3 middle(int k) const { return direction(0.5 * (low(k) + high(k))); }
    /// Where a piece is entered: the middle of a flat or an edge, near the edge before a cap.
    Vec3 entrance(int k, int step) const {
        constexpr double depth = 0.02;
        if (is_edge(k) || high(k) - low(k) < depth) return middle(k);
        return direction(step > 0 ? low(k) + 0.5 * depth : high(k) - 0.5 * depth);
    }
};

int piece_at(const SrSupport& body, const Vec3& m, double u) {
    const double n_r = (m - u * body.axis).norm();
    return static_cast<int>(support_piece(body.map, direction_measure(n_r, u)));
}

}  // namespace

void NormalStarts::add_meridian(const SrSupport& body, const Vec3& m, double sign) {
    const double u = m.dot(body.axis);
    const Vec3 off_axis = m - u * body.axis;
    const double n_r = off_axis.norm();
    if (n_r <= pole) return;
    const Meridian meridian{body.map, off_axis / n_r, body.axis, sign};
    const int here = piece_at(body, m, u);
    if (meridian.is_edge(here)) add(meridian.middle(here));
    for (const int step : {-1, 1}) {
        double length = 0.0;
        for (int k = here + step; meridian.has(k) && length < reach_; k += step) {
            length += meridian.length(k);
            add(meridian.entrance(k, step));
        }
    }
}

void NormalStarts::add_tip(const SrSupport& body, const Vec3& m, double sign,
                           const Vec3& other_axis) {
    // The circle's tangent; directions normal to it are e1 and e2.
    const Vec3 across = m.cross(other_axis);
    const double size = across.norm();
    if (size <= pole) return;
    const Vec3 tangent = across / size;
    const Vec3 in_plane = body.axis - body.axis.dot(tangent) * tangent;
    const double cosine = in_plane.norm();
    if (cosine <= pole) return;
    const Vec3 e1 = in_plane / cosine;
    const Vec3 e2 = tangent.cross(e1);
    const Meridian meridian{body.map, any_tangent(body.axis), body.axis, 1.0};
    const double u = m.dot(body.axis);
    const int here = piece_at(body, m, u);
    for (int k = here - 2; k <= here + 2; ++k) {
        if (!meridian.has(k) || meridian.is_edge(k)) continue;
        // Normals of the piece at an angle to the axis, as near to the plane as they come.
        const double along = meridian.middle(k).dot(body.axis);
        const double c = std::clamp(along / cosine, -1.0, 1.0);
        const double s = std::sqrt(1.0 - c * c);
        for (const double side : {-s, s}) add(sign * (c * e1 + side * e2));
    }
}

}  // namespace dem::runtime
