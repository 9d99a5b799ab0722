// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_wall.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

namespace dem {

template <AnyWall Wall>
PairContact collide(const Clump& a, const Wall& wall, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    const PlacedSpheres spheres(a, pair.i.orientation, Vec3::Zero());
    const double radius = spheres.bound().radius;
    const WallFrame frame{pair.displacement, body_axis(pair.j.orientation)};
    return wall.with_field(frame, clump_rounding(radius), [&](const auto& field) {
        const Vec3 center = Vec3::Zero();
        if (field.lets_pass(center)) return keep_apart(-field.sample(center).distance, memory);
        return clump_in_field(spheres, field, 1.0, list_margin(radius), 0.0,
                              {pair, law, dt, memory});
    });
}

#define DEM_CLUMP_AT(Wall)                                                                       \
    template PairContact collide(const Clump&, const Wall&, const PairState&, const ContactLaw&, \
                                 double, const NodeMemory&);
DEM_FOR_EACH_WALL_SHAPE(DEM_CLUMP_AT)

}  // namespace dem
