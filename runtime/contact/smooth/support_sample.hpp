// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/lanes.hpp"
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

template <class Real>
struct SupportSampleOf {
    Real h;                 ///< [m]
    Vec3Of<Real> meridian;  ///< unit tangent towards the axis' end that n points away from; zero at
                            ///< a pole and for a sphere
    Real tangential;        ///< x . meridian; x has no other tangential part [m]
    Real across;            ///< radius of curvature across the meridian [m]
    Real excess;            ///< of the radius along the meridian over it [m]; 0 where meridian is 0
    Real room;              ///< no jump of the curvature nearer than this [rad], a lower bound

    Real along() const { return across + excess; }
    /// The support point relative to the center of the body [m].
    Vec3Of<Real> point(const Vec3Of<Real>& n) const { return h * n + tangential * meridian; }
    /// How far the support point moves when n turns by the tangent `step` [m].
    Vec3Of<Real> shift(const Vec3Of<Real>& step) const {
        return across * step + Real(excess * meridian.dot(step)) * meridian;
    }
};
using SupportSample = SupportSampleOf<double>;

/// select() of each member.
template <class Mask, class Real>
SupportSampleOf<Real> chosen(const Mask& m, const SupportSampleOf<Real>& yes,
                             const SupportSampleOf<Real>& otherwise) {
    return {select(m, yes.h, otherwise.h),
            select(m, yes.meridian, otherwise.meridian),
            select(m, yes.tangential, otherwise.tangential),
            select(m, yes.across, otherwise.across),
            select(m, yes.excess, otherwise.excess),
            select(m, yes.room, otherwise.room)};
}

inline constexpr double no_jump = std::numeric_limits<double>::infinity();

/// A direction as seen from a body of revolution.
template <class Real>
struct AxialDirection {
    Real u;                ///< along the axis
    Vec3Of<Real> to_axis;  ///< the part of the axis across the direction
    Real n_r2, n_r;        ///< across the axis, squared and not
};
template <class Real>
AxialDirection<Real> axial_direction(const Vec3Of<Real>& n, const Vec3Of<Real>& axis) {
    const Real u = n.dot(axis);
    // Not sqrt(1 - u^2): near the poles, where faces are, that loses half of the digits.
    const Vec3Of<Real> to_axis = axis - u * n;
    const Real n_r2 = to_axis.squaredNorm();
    return {u, to_axis, n_r2, root(n_r2)};
}

/// Closer to the axis than this a direction has no meridian [rad].
inline constexpr double pole = 1e-12;

/// A piece of a support map (sr_shape.hpp, SupportPiece).
template <class Real>
struct SupportPieceOf {
    Real center_r, center_z, a, b;
};

/// Support point of a direction that belongs to a piece.
template <class Real>
SupportSampleOf<Real> support_on(const SupportPieceOf<Real>& p, const AxialDirection<Real>& n,
                                 const Real& room) {
    const MaskOf<Real> is_arc = p.a == p.b;
    Real r = p.center_r + p.a * n.n_r;
    Real z = p.center_z + p.a * n.u;
    Real along = p.a;
    if (!all(is_arc)) {
        const Real a2 = p.a * p.a;
        const Real b2 = p.b * p.b;
        const Real scale = 1.0 / root(a2 * n.n_r2 + b2 * (n.u * n.u));
        r = select(is_arc, r, p.center_r + a2 * n.n_r * scale);
        z = select(is_arc, z, p.center_z + b2 * n.u * scale);
        along = select(is_arc, along, a2 * b2 * (scale * scale * scale));
    }
    const Real h = r * n.n_r + z * n.u;
    const Real inverse = 1.0 / n.n_r;
    const Real across = r * inverse;
    SupportSampleOf<Real> s{h,      inverse * n.to_axis, z * n.n_r - r * n.u,
                            across, along - across,      room};
    const MaskOf<Real> is_pole = n.n_r <= pole;
    if (any(is_pole)) {
        s.meridian = select(is_pole, Vec3Of<Real>(Vec3Of<Real>::Zero()), s.meridian);
        s.tangential = select(is_pole, Real{}, s.tangential);
        s.across = select(is_pole, along, s.across);
        s.excess = select(is_pole, Real{}, s.excess);
    }
    return s;
}

/// Support function of a convex surface of revolution.
struct SrSupport {
    const SupportMap& map;
    Vec3 axis;  ///< world

    SupportSample operator()(const Vec3& n) const {
        const AxialDirection<double> direction = axial_direction<double>(n, axis);
        std::uint32_t index = 0;
        double room = no_jump;
        if (map.pieces.size() > 1) find_piece(map, direction.n_r, direction.u, index, room);
        const SupportPiece& p = map.pieces[index];
        return support_on({p.center_r, p.center_z, p.a, p.b}, direction, room);
    }

    const SupportBounds& bounds() const { return map.bounds; }

    /// The piece of a direction and how far it is to its ends [rad].
    static void find_piece(const SupportMap& map, double n_r, double u, std::uint32_t& index,
                           double& room) {
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
        if (n_r <= pole) return {0.0, Vec3::Zero(), 0.0, 0.0, 0.0, 0.0};
        const double across = radius / n_r;
        return {radius * n_r, to_axis / n_r, -radius * u, across, -across, n_r};
    }
};

/// 1/H of one side of a contact, clamped to [0.01 d_eq, 5 d_eq] (docs/contact.md, "Effective
/// radius") [m].
template <class Real>
Real mean_curvature_radius(const SupportSampleOf<Real>& s, const Real& equivalent_diameter) {
    const Real along = s.along();
    const Real sum = along + s.across;
    const Real radius = select(sum > 0.0, 2.0 * along * s.across / sum, Real{});
    return clamped<Real>(radius, 0.01 * equivalent_diameter, 5.0 * equivalent_diameter);
}

}  // namespace dem::runtime
