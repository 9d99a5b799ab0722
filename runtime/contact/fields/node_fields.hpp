// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sdf_quadtree.hpp"
#include "common/shapes/sr_shape.hpp"
#include "common/shapes/support_map.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/fields/sdf_vectors.hpp"
#include "runtime/contact/walls/wall_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// The surfaces that the nodes of a body are tested against, each placed in the frame of that body
/// (so nodes are never moved). A field offers
///
///     Sample sample(x)            .distance: signed, negative inside [m]; and what follows from it
///     Vec3 gradient(x, sample)    of the distance, exact
///     bool accepts(x)             false where the surface has been cut off (a rim)
///     double slack                distance(x) - distance(y) <= |x - y| + slack, y near the surface
///     double floor(x)             cheap lower bound of the distance, or -infinity [m]
///     double proven_gap(d)        a point at distance d >= 0 now, or farther, does not touch
///                                 before it has come nearer to the surface by this [m]
///
/// and, where its gradient may turn at once (crease.hpp),
///
///     bool may_turn_within(sample, way)   whether it may so near to where it was sampled [m]
namespace dem::runtime {

/// The interpolated distance field of a surface of revolution. Only the center and the axis of the
/// other body matter ([SR] Lemma 1).
struct SrField {
    struct Sample : SdfSample {
        double r;  ///< distance from the axis [m]
        double z;  ///< along the axis, from the center [m]
    };

    const SdfQuadtree* sdf;
    Vec3 center;  ///< [m]
    Vec3 axis;    ///< unit
    double slack;
    /// A plane with the whole body behind it, if one has been set.
    Vec3 floor_normal = Vec3::Zero();
    double floor_offset = std::numeric_limits<double>::infinity();

    SrField(const SrShape& shape, const Vec3& slave_center, const Vec3& slave_axis)
        : sdf(&shape.sdf),
          center(slave_center),
          axis(slave_axis),
          slack(sdf->lipschitz_slack +
                (sdf->surface_band > 0.0 ? sdf->surface_slack : sdf->lipschitz_slack)) {}

    Sample sample(const Vec3& x) const {
        const Vec3 d = x - center;
        const double z = d.dot(axis);
        // Not sqrt(d^2 - z^2), which loses half the digits near the axis.
        const double r = (d - z * axis).norm();
        return {interpolate(*sdf, r, z), r, z};
    }
    Vec3 gradient(const Vec3& x, const Sample& s) const { return in_space(x, s, s.d_dr, s.d_dz); }

    /// A direction (r, z) of the half plane through x; nothing points away from the axis on it.
    Vec3 in_space(const Vec3& x, const Sample& s, double along_r, double along_z) const {
        const Vec3 radial = x - center - s.z * axis;
        return (s.r > 0.0 ? along_r / s.r : 0.0) * radial + along_z * axis;
    }
    /// [SR] Sec. 2.4: interpolated distance vector [m].
    Vec3 distance_vector(const Vec3& x, const Sample& s) const {
        const Vec2 d = interpolated_distance_vector(*sdf, s.r, s.z);
        return in_space(x, s, d.x(), d.y());
    }
    static bool accepts(const Vec3& /*x*/) { return true; }

    double floor(const Vec3& x) const { return x.dot(floor_normal) - floor_offset; }

    /// Sets the floor to the tangent plane of a convex shape with the given outward unit normal.
    void set_floor(const SrShape& shape, const Vec3& normal) {
        if (shape.support.pieces.empty()) return;
        const double n_z = std::clamp(normal.dot(axis), -1.0, 1.0);
        const double n_r = std::sqrt(1.0 - n_z * n_z);
        const SupportPoint s = support_point(shape.support, n_r, n_z);
        // The support map's crowned flats differ from the body by 3e-5 l at most (docs/contact.md).
        floor_offset =
            normal.dot(center) + s.r * n_r + s.z * n_z + slack + 1e-4 * shape.major_axis_length;
        floor_normal = normal;
    }

    /// On its way to the surface the point crosses the band where the interpolant is good.
    double proven_gap(double distance) const {
        return std::max(distance - 2.0 * sdf->lipschitz_slack,
                        std::min(distance, sdf->surface_band) - 2.0 * sdf->surface_slack);
    }
};

/// A ball: positive distance outside.
struct SphereField : ExactField {
    struct Sample {
        double distance;
    };

    Vec3 center;    ///< [m]
    double radius;  ///< [m]

    Sample sample(const Vec3& x) const { return {(x - center).norm() - radius}; }
    Vec3 gradient(const Vec3& x, const Sample& s) const {
        return (x - center) / (s.distance + radius);
    }
};

}  // namespace dem::runtime
