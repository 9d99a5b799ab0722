// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_convex.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/fields/core_field.hpp"

namespace dem::runtime {

PairContact collide(const Clump& a, const ConvexShape& b, const PatchCall& call) {
    const PairState& pair = call.pair;
    const PlacedSpheres spheres(a, pair.i.orientation, Vec3::Zero());
    const ConvexField field{{clump_rounding(b.bounding_radius)},
                            &b,
                            pair.j.orientation.toRotationMatrix(),
                            pair.displacement};
    const double margin = list_margin(std::min(spheres.bound().radius, b.bounding_radius));
    return clump_in_field(spheres, field, margin, 2.0 / b.equivalent_diameter, call);
}

}  // namespace dem::runtime
