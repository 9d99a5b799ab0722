// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_in_field.hpp"

#include "runtime/contact/pairs/convex_wall.hpp"

// Apart from the kernels of planes and cylinders, of which the compiler would inline less.
namespace dem {

template <AnyWall Wall>
PairContact collide(const ConvexShape& a, const Wall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const WallFrame frame{pair.displacement, body_axis(pair.j.orientation)};
    return wall.with_field(frame, 0.0, [&](const auto& field) {
        return convex_in_field(a, field, {pair, law, dt, memory});
    });
}

#define DEM_CONVEX_AT(Wall)                                                         \
    template PairContact collide(const ConvexShape&, const Wall&, const PairState&, \
                                 const ContactLaw&, double, const ConvexMemory&);
DEM_FOR_EACH_WALL_SHAPE(DEM_CONVEX_AT)

}  // namespace dem
