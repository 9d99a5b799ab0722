// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_convex.hpp"

#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/ellipsoid_normal.hpp"

namespace dem {

namespace {

/// Two bodies without flat parts: the common normal.
PairContact smooth(const RoundEllipsoid& i, const RoundEllipsoid& j, const ConvexRadius& radius,
                   const ConvexCall& call) {
    const ConvexMemory& memory = call.memory;
    const Vec3& d = call.pair.displacement;
    const double spheres = d.norm() - i.size - j.size;
    if (spheres > 0.0) return keep_apart(memory, spheres, memory.miss.axis);
    const bool touched = memory.history.effective_radius > 0.0;
    const Vec3 axis = memory.miss.axis;
    if (!touched && axis.squaredNorm() > 0.0) {
        const double gap = -overlap_along(i, j, d, axis);
        if (gap > 0.0) return keep_apart(memory, gap, axis);
    }
    const StoredVec3 start =
        touched ? memory.history.search.direction : canonical_start(d).direction;
    const EllipsoidNormal at = common_normal(i, j, d, -Vec3(start));
    if (!(at.overlap > 0.0)) return keep_apart(memory, -at.overlap, at.n);
    PairContact contact = single_contact({at.middle, -at.n, at.overlap}, radius, call);
    memory.history.search.direction = Vec3(-at.n);
    return contact;
}

/// A sphere against a core, in closed form. `sign`: 1 where the sphere is i.
PairContact sphere_contact(const Sphere& sphere, const Vec3& center, const PlacedCore& core,
                           double sign, const ConvexCall& call) {
    const SurfaceDistance d = surface_distance(core.shape, core.in_body(center));
    const double overlap = sphere.radius - d.distance;
    const Vec3 away = core.turned(d.normal);
    if (!(overlap > 0.0)) return keep_apart(call.memory, -overlap, -sign * away);
    const FeaturePoint point{center - (sphere.radius - 0.5 * overlap) * away, sign * away, overlap};
    return single_contact(point, {2.0 * sphere.radius, core.shape.equivalent_diameter}, call);
}

}  // namespace

PairContact collide(const ConvexShape& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const ConvexRadius radius{a.equivalent_diameter, b.equivalent_diameter};
    const ConvexCall call{pair, law, dt, memory};
    if (a.is_strictly_convex() && b.is_strictly_convex())
        return smooth({a, pair.i.orientation}, {b, pair.j.orientation}, radius, call);
    const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
    const PlacedCore j(b, pair.j.orientation, pair.displacement);
    return between_cores(i, j, radius, call);
}

PairContact collide(const Sphere& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const PlacedCore core(b, pair.j.orientation, pair.displacement);
    return sphere_contact(a, Vec3::Zero(), core, 1.0, {pair, law, dt, memory});
}

PairContact collide(const ConvexShape& a, const Sphere& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const PlacedCore core(a, pair.i.orientation, Vec3::Zero());
    return sphere_contact(b, pair.displacement, core, -1.0, {pair, law, dt, memory});
}

}  // namespace dem
