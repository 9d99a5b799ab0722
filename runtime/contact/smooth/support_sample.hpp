// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/support_map.hpp"
#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// Support functions of bodies, with gradient and curvature, as the common-normal search needs them
/// (docs/contact.md, "Common normal"). For a unit direction n the support point x maximizes n.x and
/// h = n.x; the tangential part of x is the gradient of h on the unit sphere, the radii of
/// curvature at x its second derivative.
namespace dem::runtime {

struct SupportSample {
    double h;           ///< [m]
    Vec3 meridian;      ///< unit tangent towards the axis' end that n points away from; zero at a
                        ///< pole and for a sphere
    double tangential;  ///< x . meridian; x has no other tangential part [m]
    double across;      ///< radius of curvature across the meridian [m]
    double excess;      ///< of the radius along the meridian over it [m]; 0 where meridian is zero
    double room;        ///< no jump of the curvature nearer than this [rad], a lower bound

    double along() const { return across + excess; }
    /// The support point relative to the center of the body [m].
    Vec3 point(const Vec3& n) const { return h * n + tangential * meridian; }
    /// How far the support point moves when n turns by the tangent `step` [m].
    Vec3 shift(const Vec3& step) const {
        return across * step + (excess * meridian.dot(step)) * meridian;
    }
};

inline constexpr double no_jump = std::numeric_limits<double>::infinity();

/// Support function of a convex surface of revolution.
struct SrSupport {
    const SupportMap& map;
    Vec3 axis;  ///< world

    SupportSample operator()(const Vec3& n) const {
        const double u = n.dot(axis);
        // Not sqrt(1 - u^2): near the poles, where faces are, that loses half of the digits.
        const Vec3 to_axis = axis - u * n;
        const double n_r2 = to_axis.squaredNorm();
        const double n_r = std::sqrt(n_r2);
        std::uint32_t index = 0;
        double room = no_jump;
        if (map.pieces.size() > 1) find_piece(n_r, u, index, room);
        const SupportPiece& p = map.pieces[index];
        double r = p.center_r;
        double z = p.center_z;
        double along = p.a;
        if (p.a == p.b) {
            r += p.a * n_r;
            z += p.a * u;
        } else {
            const double a2 = p.a * p.a;
            const double b2 = p.b * p.b;
            const double scale = 1.0 / std::sqrt(a2 * n_r2 + b2 * (u * u));
            r += a2 * n_r * scale;
            z += b2 * u * scale;
            along = a2 * b2 * (scale * scale * scale);
        }
        const double h = r * n_r + z * u;
        if (n_r <= pole) return {h, Vec3::Zero(), 0.0, along, 0.0, room};
        const double inverse = 1.0 / n_r;
        const double across = r * inverse;
        return {h, inverse * to_axis, z * n_r - r * u, across, along - across, room};
    }

    /// Closer to the axis than this the direction has no meridian [rad].
    static constexpr double pole = 1e-12;

  private:
    void find_piece(double n_r, double u, std::uint32_t& index, double& room) const {
        const double q = direction_measure(n_r, u);
        index = support_piece(map, q);
        // q changes by at most one per radian. Beyond a pole the same piece goes on.
        if (index > 0) room = q - map.piece_end[index - 1];
        if (index + 1 < map.pieces.size()) room = std::min(room, map.piece_end[index] - q);
    }
};

struct SphereSupport {
    double radius;

    SupportSample operator()(const Vec3&) const {
        return {radius, Vec3::Zero(), 0.0, radius, 0.0, no_jump};
    }
};

/// A circle about its center: the edge of a flat end.
struct CircleSupport {
    double radius;
    Vec3 axis;  ///< unit, normal of its plane

    SupportSample operator()(const Vec3& n) const {
        const double u = n.dot(axis);
        const Vec3 to_axis = axis - u * n;
        const double n_r = to_axis.norm();
        if (n_r <= SrSupport::pole) return {0.0, Vec3::Zero(), 0.0, 0.0, 0.0, 0.0};
        const double across = radius / n_r;
        return {radius * n_r, to_axis / n_r, -radius * u, across, -across, n_r};
    }
};

/// 1/H of one side of a contact, clamped to [0.01 d_eq, 5 d_eq] (docs/contact.md, "Effective
/// radius") [m].
inline double mean_curvature_radius(const SupportSample& s, double equivalent_diameter) {
    const double along = s.along();
    const double sum = along + s.across;
    const double radius = sum > 0.0 ? 2.0 * along * s.across / sum : 0.0;
    return std::clamp(radius, 0.01 * equivalent_diameter, 5.0 * equivalent_diameter);
}

}  // namespace dem::runtime
