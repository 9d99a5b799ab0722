// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_convex.hpp"

#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/ellipsoid_normal.hpp"

namespace dem::runtime {

namespace {

/// Two bodies without flat parts: the common normal.
PairContact smooth(const RoundEllipsoid& i, const RoundEllipsoid& j, const ConvexRadius& radius,
                   const CoreCall& call) {
    const auto& memory = call.memory;
    const Vec3& d = call.pair.displacement;
    const double spheres = d.norm() - i.size - j.size;
    if (spheres > 0.0) return apart(call, spheres, memory.cache.axis);
    const bool touched = memory.history.touched();
    const Vec3 axis = memory.cache.axis;
    if (!touched && axis.squaredNorm() > 0.0) {
        const double gap = -overlap_along(i, j, d, axis);
        if (gap > 0.0) return apart(call, gap, axis);
    }
    const StoredVec3 start =
        touched ? memory.history.search.direction : canonical_start(d).direction;
    const EllipsoidNormal at = common_normal(i, j, d, -Vec3(start));
    if (!(at.overlap > 0.0)) return apart(call, -at.overlap, at.n);
    PairContact contact = single_contact({at.middle, -at.n, at.overlap}, radius, call);
    memory.history.search.direction = Vec3(-at.n);
    return contact;
}

}  // namespace

PairContact collide(const ConvexShape& a, const ConvexShape& b, const CoreCall& call) {
    const PairState& pair = call.pair;
    const ConvexRadius radius{a.equivalent_diameter, b.equivalent_diameter};
    if (a.is_strictly_convex() && b.is_strictly_convex())
        return smooth({a, pair.i.orientation}, {b, pair.j.orientation}, radius, call);
    const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
    const PlacedCore j(b, pair.j.orientation, pair.displacement);
    return between_cores(i, j, radius, call);
}

// In closed form.
PairContact collide(const Sphere& a, const ConvexShape& b, const CoreCall& call) {
    const PlacedCore core(b, call.pair.j.orientation, call.pair.displacement);
    const SurfaceDistance d = surface_distance(b, core.in_body(Vec3::Zero()));
    const double overlap = a.radius - d.distance;
    const Vec3 away = core.turned(d.normal);
    if (!(overlap > 0.0)) return apart(call, -overlap, -away);
    const FeaturePoint point{-(a.radius - 0.5 * overlap) * away, away, overlap};
    return single_contact(point, {2.0 * a.radius, b.equivalent_diameter}, call);
}

}  // namespace dem::runtime
