// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_convex.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/fields/core_field.hpp"

namespace dem {

namespace {

/// `sign`: 1 where the clump is i.
PairContact between(const PlacedSpheres& spheres, const ConvexField& field, double sign,
                    const NodeCall& call) {
    const double margin =
        list_margin(std::min(spheres.bound().radius, field.shape->bounding_radius));
    return clump_in_field(spheres, field, sign, margin, 2.0 / field.shape->equivalent_diameter,
                          call);
}

ConvexField field_of(const ConvexShape& shape, const Quat& orientation, const Vec3& center) {
    return {
        {clump_rounding(shape.bounding_radius)}, &shape, orientation.toRotationMatrix(), center};
}

}  // namespace

PairContact collide(const Clump& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    return between({a, pair.i.orientation, Vec3::Zero()},
                   field_of(b, pair.j.orientation, pair.displacement), 1.0,
                   {pair, law, dt, memory});
}

PairContact collide(const ConvexShape& a, const Clump& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    return between({b, pair.j.orientation, pair.displacement},
                   field_of(a, pair.i.orientation, Vec3::Zero()), -1.0, {pair, law, dt, memory});
}

}  // namespace dem
