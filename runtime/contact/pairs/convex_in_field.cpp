// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_in_field.hpp"

#include "runtime/contact/pairs/convex_wall.hpp"

// Apart from the kernels of planes and cylinders, of which the compiler would inline less.
namespace dem::runtime {

template <AnyWall Wall>
PairContact collide(const ConvexShape& a, const Wall& wall, const CoreCall& call) {
    const WallFrame frame{call.pair.displacement, body_axis(call.pair.j.orientation)};
    return wall.with_field(frame, 0.0,
                           [&](const auto& field) { return convex_in_field(a, field, call); });
}

#define DEM_CONVEX_AT(Wall) \
    template PairContact collide(const ConvexShape&, const Wall&, const CoreCall&);
DEM_FOR_EACH_WALL_SHAPE(DEM_CONVEX_AT)

}  // namespace dem::runtime
