// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {

/// Support point of a convex profile in the half plane with the local shape of the surface there.
struct SupportPoint {
    double r, z;               ///< [m]
    double meridional_radius;  ///< 1/kappa_1, radius of curvature of the profile [m]; 0 at a corner
    double circumferential_radius;  ///< 1/kappa_2 = r / n_r [m]; at the poles the meridional one
};

/// q of a direction (sr_shape.hpp, SupportMap), n_r >= 0. Changes by 1/2 to 1 per radian.
inline double direction_measure(double n_r, double n_z) {
    return n_z / (n_r + std::abs(n_z));
}

/// Index of the piece that holds the direction of measure q.
inline std::uint32_t support_piece(const SupportMap& map, double q) {
    const auto buckets = static_cast<double>(map.first_piece.size() - 1);
    const double bucket = 0.5 * (q + 1.0) * buckets;
    const auto k = bucket < buckets ? static_cast<std::uint32_t>(bucket)
                                    : static_cast<std::uint32_t>(map.first_piece.size() - 2);
    std::uint32_t piece = map.first_piece[k];
    while (q > map.piece_end[piece]) ++piece;  // the last piece ends at q = 1
    return piece;
}

/// Radius of curvature of a piece where it is flattest [m].
inline double longest_radius(const SupportPiece& p) {
    const double longer = std::max(p.a, p.b);
    const double shorter = std::min(p.a, p.b);
    if (longer == 0.0) return 0.0;
    return shorter > 0.0 ? longer * longer / shorter : std::numeric_limits<double>::infinity();
}

/// Radius of curvature of the meridian where a piece is most curved [m]; 0: a corner.
inline double shortest_radius(const SupportPiece& p) {
    const double longer = std::max(p.a, p.b);
    const double shorter = std::min(p.a, p.b);
    return longer > 0.0 ? shorter * shorter / longer : 0.0;
}

/// Longest radius of curvature of the whole meridian [m]. None across the meridian is longer: the
/// circumferential one is a mean of the meridional ones between the pole and the place.
inline double longest_radius(const SupportMap& map) {
    double longest = 0.0;
    for (const SupportPiece& p : map.pieces) longest = std::max(longest, longest_radius(p));
    return longest;
}

/// Support point of the unit direction (n_r, n_z), n_r >= 0 (sr_shape.hpp, SupportPiece).
inline SupportPoint support_point(const SupportMap& map, double n_r, double n_z) {
    const SupportPiece& p =
        map.pieces[map.pieces.size() == 1 ? 0 : support_piece(map, direction_measure(n_r, n_z))];
    SupportPoint s{p.center_r, p.center_z, 0.0, 0.0};
    if (p.a == p.b) {
        s.r += p.a * n_r;
        s.z += p.a * n_z;
        s.meridional_radius = p.a;
    } else {
        const double a2 = p.a * p.a;
        const double b2 = p.b * p.b;
        const double w2 = a2 * n_r * n_r + b2 * n_z * n_z;
        const double w = std::sqrt(w2);
        s.r += a2 * n_r / w;
        s.z += b2 * n_z / w;
        s.meridional_radius = a2 * b2 / (w2 * w);
    }
    s.circumferential_radius = n_r > 1e-12 ? s.r / n_r : s.meridional_radius;
    return s;
}

}  // namespace dem
