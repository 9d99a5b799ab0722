// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sphere_wall.hpp"

#include "runtime/contact/law/sphere_force.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

#include <algorithm>

namespace dem {

namespace {

/// The surface point of a wall nearest to a sphere's centre, seen from the centre.
struct Nearest {
    Vec3 normal;      ///< unit, from the wall towards the centre
    double distance;  ///< of the centre in front of the wall, negative behind [m]
};

PairContact touch(const Sphere& a, const Nearest& nearest, const PairState& pair,
                  const ContactLaw& law, double dt, PointHistory& history) {
    const double overlap = a.radius - nearest.distance;
    if (!(overlap > 0.0)) {
        if (history.effective_radius > 0.0) history = {};
        return {};
    }
    const Vec3 r_i = -(a.radius - 0.5 * overlap) * nearest.normal;
    return sphere_force<Partner::wall>({nearest.normal, overlap, r_i, a.radius}, pair, law, dt,
                                       history);
}

constexpr double far_away = std::numeric_limits<double>::infinity();

/// Of a solid rod, z = 0 .. length.
Nearest nearest_of_rod(const CylinderWall& wall, const AxialPoint& c, const Vec3& axis) {
    const double beyond_side = c.r - wall.radius;
    if (std::isinf(wall.length)) return {c.radial, beyond_side};
    const double beyond_end = std::max(-c.z, c.z - wall.length);
    const Vec3 end_normal = c.z < 0.5 * wall.length ? Vec3(-axis) : axis;
    if (beyond_end <= 0.0 || beyond_side <= 0.0) {
        // In front of the side or of an end face, or inside: the face it is least deep behind.
        if (beyond_side > beyond_end) return {c.radial, beyond_side};
        return {end_normal, beyond_end};
    }
    const double distance = std::sqrt(square(beyond_side) + square(beyond_end));
    return {(beyond_side * c.radial + beyond_end * end_normal) / distance, distance};
}

}  // namespace

PairContact collide(const Sphere& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, PointHistory& history) {
    const Vec3 axis = body_axis(pair.j.orientation);
    Nearest nearest{axis, -pair.displacement.dot(axis)};
    if (std::isfinite(wall.radius)) {
        const double r2 = pair.displacement.squaredNorm() - square(nearest.distance);
        if (nearest.distance < 0.0 || r2 > square(wall.radius)) nearest.distance = far_away;
    }
    return touch(a, nearest, pair, law, dt, history);
}

PairContact collide(const Sphere& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, PointHistory& history) {
    const Vec3 axis = body_axis(pair.j.orientation);
    const AxialPoint c = axial_point(-pair.displacement, axis);
    if (!wall.inside) return touch(a, nearest_of_rod(wall, c, axis), pair, law, dt, history);
    Nearest nearest{-c.radial, wall.radius - c.r};
    const bool beyond = std::isfinite(wall.length) && (c.z < 0.0 || c.z > wall.length);
    if (beyond) nearest.distance = far_away;
    return touch(a, nearest, pair, law, dt, history);
}

}  // namespace dem
