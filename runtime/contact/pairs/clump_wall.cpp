// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_wall.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

namespace dem::runtime {

template <AnyWall Wall>
PairContact collide(const Clump& a, const Wall& wall, const PatchCall& call) {
    const PairState& pair = call.pair;
    const PlacedSpheres spheres(a, pair.i.orientation, Vec3::Zero());
    const double radius = spheres.bound().radius;
    const WallFrame frame{pair.displacement, body_axis(pair.j.orientation)};
    return wall.with_field(frame, clump_rounding(radius), [&](const auto& field) {
        const Vec3 center = Vec3::Zero();
        if (field.lets_pass(center)) return apart(call, -field.sample(center).distance);
        return clump_in_field(spheres, field, list_margin(radius), 0.0, call);
    });
}

#define DEM_CLUMP_AT(Wall) \
    template PairContact collide(const Clump&, const Wall&, const PatchCall&);
DEM_FOR_EACH_WALL_SHAPE(DEM_CLUMP_AT)

}  // namespace dem::runtime
