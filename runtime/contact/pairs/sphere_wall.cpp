// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sphere_wall.hpp"

namespace dem::runtime {

template <AnyWall Wall>
PairContact collide(const Sphere& a, const Wall& wall, const SphereCall& call) {
    const PairState& pair = call.pair;
    const WallFrame frame{pair.displacement, body_axis(pair.j.orientation)};
    return wall.with_field(frame, 0.0, [&](const auto& field) -> PairContact {
        const auto here = field.sample(Vec3::Zero());
        if (!touches_wall(field, here, a.radius)) return apart(call);
        return sphere_force<Partner::wall>(sphere_at_wall(field, here, a.radius), pair, call.law,
                                           call.dt, call.memory.history);
    });
}

#define DEM_SPHERE_AT(Wall) \
    template PairContact collide(const Sphere&, const Wall&, const SphereCall&);
DEM_FOR_EACH_WALL_SHAPE(DEM_SPHERE_AT)

}  // namespace dem::runtime
