// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sphere_wall.hpp"

#include "runtime/contact/law/sphere_force.hpp"

namespace dem::runtime {

template <AnyWall Wall>
PairContact collide(const Sphere& a, const Wall& wall, const SphereCall& call) {
    const PairState& pair = call.pair;
    const WallFrame frame{pair.displacement, body_axis(pair.j.orientation)};
    return wall.with_field(frame, 0.0, [&](const auto& field) -> PairContact {
        const Vec3 center = Vec3::Zero();
        const auto sample = field.sample(center);
        const double overlap = a.radius - sample.distance;
        if (!(overlap > 0.0) || !field.accepts(center) || field.lets_pass(center))
            return apart(call);
        const Vec3 normal = field.gradient(center, sample);
        const Vec3 r_i = -(a.radius - 0.5 * overlap) * normal;
        return sphere_force<Partner::wall>(SpherePointOf<double>{normal, overlap, r_i, a.radius},
                                           pair, call.law, call.dt, call.memory.history);
    });
}

#define DEM_SPHERE_AT(Wall) \
    template PairContact collide(const Sphere&, const Wall&, const SphereCall&);
DEM_FOR_EACH_WALL_SHAPE(DEM_SPHERE_AT)

}  // namespace dem::runtime
