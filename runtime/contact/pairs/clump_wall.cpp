// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_wall.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

#include <cmath>

namespace dem {

namespace {

template <class Field>
PairContact against(const PlacedSpheres& spheres, const Field& field, const NodeCall& call) {
    return clump_in_field(spheres, field, 1.0, list_margin(spheres.bound().radius), 0.0, call);
}

}  // namespace

PairContact collide(const Clump& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeCall call{pair, law, dt, memory};
    const Vec3 normal = body_axis(pair.j.orientation);
    const double in_front = -pair.displacement.dot(normal);
    // A disc acts on bodies in front of it; one behind has at least the way through it to go.
    if (std::isfinite(wall.radius) && in_front <= 0.0) return keep_apart(-in_front, memory);
    const PlacedSpheres spheres(a, pair.i.orientation, Vec3::Zero());
    const PlaneField field{
        {clump_rounding(spheres.bound().radius)}, pair.displacement, normal, wall.radius};
    return against(spheres, field, call);
}

PairContact collide(const Clump& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeCall call{pair, law, dt, memory};
    const Vec3 axis = body_axis(pair.j.orientation);
    const PlacedSpheres spheres(a, pair.i.orientation, Vec3::Zero());
    const ExactField exact{clump_rounding(spheres.bound().radius)};
    if (wall.inside) {
        const TubeField tube{exact, pair.displacement, axis, wall.radius, wall.length};
        return against(spheres, tube, call);
    }
    const RodField rod{exact, pair.displacement, axis, wall.radius, wall.length};
    return against(spheres, rod, call);
}

}  // namespace dem
