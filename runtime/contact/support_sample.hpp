// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/support_map.hpp"
#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <cmath>

/// Support functions of bodies, with gradient and curvature, as the common-normal search needs them
/// (docs/contact.md, "Common normal"). For a unit direction n the support point x maximises n.x and
/// h = n.x; the tangential part of x is the gradient of h on the unit sphere, the radii of
/// curvature at x its second derivative.
namespace dem {

struct SupportSample {
    double h;           ///< [m]
    Vec3 meridian;      ///< unit tangent towards the axis' end that n points away from; zero at a
                        ///< pole and for a sphere
    double tangential;  ///< x . meridian; x has no other tangential part [m]
    double across;      ///< radius of curvature across the meridian [m]
    double excess;      ///< of the radius along the meridian over it [m]; 0 where meridian is zero

    double along() const { return across + excess; }
    /// The support point relative to the centre of the body [m].
    Vec3 point(const Vec3& n) const { return h * n + tangential * meridian; }
};

/// Of a convex surface of revolution.
struct SrSupport {
    const SupportMap& map;
    Vec3 axis;  ///< world

    SupportSample operator()(const Vec3& n) const {
        const double u = n.dot(axis);
        // Not sqrt(1 - u^2): near the poles, where faces are, that loses half of the digits.
        const Vec3 to_axis = axis - u * n;
        const double n_r = to_axis.norm();
        const SupportPoint s = support_point(map, n_r, u);
        SupportSample sample{s.r * n_r + s.z * u, Vec3::Zero(), 0.0, s.circumferential_radius, 0.0};
        if (n_r > pole) {
            sample.meridian = to_axis / n_r;
            sample.tangential = s.z * n_r - s.r * u;
            sample.excess = s.meridional_radius - s.circumferential_radius;
        }
        return sample;
    }

    /// Closer to the axis than this the direction has no meridian [rad].
    static constexpr double pole = 1e-12;
};

struct SphereSupport {
    double radius;

    SupportSample operator()(const Vec3&) const { return {radius, Vec3::Zero(), 0.0, radius, 0.0}; }
};

/// A circle about its centre: the edge of a flat end.
struct CircleSupport {
    double radius;
    Vec3 axis;  ///< unit, normal of its plane

    SupportSample operator()(const Vec3& n) const {
        const double u = n.dot(axis);
        const Vec3 to_axis = axis - u * n;
        const double n_r = to_axis.norm();
        if (n_r <= SrSupport::pole) return {0.0, Vec3::Zero(), 0.0, 0.0, 0.0};
        const double across = radius / n_r;
        return {radius * n_r, to_axis / n_r, -radius * u, across, -across};
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

}  // namespace dem
