// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/support.hpp"

#include "common/math/elementary.hpp"
#include "common/shapes/support_bounds.hpp"
#include "common/shapes/support_map.hpp"
#include "shapegen/revolution/arc_spline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dem::shapegen {
namespace {

/// First piece of each of `buckets` equal ranges of q.
std::vector<std::uint32_t> first_pieces(const std::vector<double>& ends, std::size_t buckets) {
    std::vector<std::uint32_t> first(buckets + 1);
    std::size_t piece = 0;
    for (std::size_t k = 0; k <= buckets; ++k) {
        const double start = 2.0 * static_cast<double>(k) / static_cast<double>(buckets) - 1.0;
        while (piece + 1 < ends.size() && ends[piece] < start) ++piece;
        first[k] = static_cast<std::uint32_t>(piece);
    }
    return first;
}

/// The index with as many buckets as keep a look-up short: no more than 16 pieces in any bucket,
/// unless that takes more than 4 buckets per piece.
std::vector<std::uint32_t> make_index(const std::vector<double>& ends) {
    for (std::size_t buckets = 64;; buckets *= 2) {
        std::vector<std::uint32_t> first = first_pieces(ends, buckets);
        std::uint32_t longest = 0;
        for (std::size_t k = 0; k < buckets; ++k)
            longest = std::max(longest, first[k + 1] - first[k]);
        if (longest <= 16 || buckets >= 4 * ends.size()) return first;
    }
}

double difference(const SupportMap& map, const Vec2& normal, const Vec2& point) {
    const SupportPoint found = support_point(map, std::max(normal.x(), 0.0), normal.y());
    return std::abs(normal.dot(Vec2(found.r, found.z) - point));
}

/// Over the fan of normals from one to another at a corner.
double fan_difference(const SupportMap& map, const Vec2& from, const Vec2& to, const Vec2& point) {
    constexpr int parts = 64;
    const double angle = turn(from, to);
    double largest = 0.0;
    for (int i = 0; i <= parts && angle > 0.0; ++i) {
        const double c = math::cos(angle * i / parts);
        const double s = math::sin(angle * i / parts);
        const Vec2 normal(c * from.x() - s * from.y(), s * from.x() + c * from.y());
        largest = std::max(largest, difference(map, normal, point));
    }
    return largest;
}

}  // namespace

SupportMap support_map(const Profile& profile) {
    SupportPieces pieces(profile.major_axis_length());
    Vec2 normal(0.0, -1.0);
    for (const SupportLink& link : support_links(profile)) {
        if (link.is_end_face) {
            if (link.from.x() != 0.0) pieces.append_corner(link.from, link.first_normal);
            pieces.append_end_face(link);
        } else {
            if (turn(normal, link.first_normal) > 0.0)
                pieces.append_corner(link.from, link.first_normal);
            if (link.is_flat()) {
                pieces.append_biarc(link);
            } else {
                pieces.append_curve(profile.segments()[*link.segment], link);
            }
        }
        normal = link.last_normal;
    }
    pieces.append_corner(Vec2(0.0, profile.top_z()), Vec2(0.0, 1.0));

    std::vector<double> ends = pieces.take_ends();
    ends.back() = 1.0;
    SupportMap map;
    map.first_piece = make_index(ends);
    map.pieces = pieces.take_pieces();
    map.piece_end = std::move(ends);
    map.bounds = support_bounds(map);
    return map;
}

double support_error(const Profile& profile, const SupportMap& map) {
    constexpr int parts = 64;
    double largest = 0.0;
    Vec2 last(0.0, -1.0);
    for (const ProfilePiece& piece : profile.pieces()) {
        const ProfileSegment& segment = profile.segments()[piece.segment];
        const Vec2 first = profile.outward_normal(piece.segment, piece.t0);
        largest = std::max(largest, fan_difference(map, last, first, piece.from));
        for (int i = 0; i <= parts; ++i) {
            const double t = piece.t0 + (piece.t1 - piece.t0) * i / parts;
            largest = std::max(largest, difference(map, profile.outward_normal(piece.segment, t),
                                                   evaluate(segment, t).point));
        }
        last = profile.outward_normal(piece.segment, piece.t1);
    }
    const Vec2 top(0.0, profile.top_z());
    return std::max(largest, fan_difference(map, last, Vec2(0.0, 1.0), top));
}

}  // namespace dem::shapegen
