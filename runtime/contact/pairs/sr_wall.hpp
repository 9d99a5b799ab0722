// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

#include <type_traits>

/// Convex surfaces of revolution against walls with a kernel by support maps, exact. The wall's
/// curvature does not enter R*.
namespace dem::runtime {

/// What the smooth kernel of a wall remembers of a contact. Walls that are not named here have no
/// such kernel: they are touched by nodes (sr_wall_nodes.hpp).
template <class Wall>
struct SmoothHistory {};
template <>
struct SmoothHistory<PlaneWall> {
    using Type = PointHistory;
};
template <>
struct SmoothHistory<CylinderWall> {
    using Type = PatchHistory;
};
template <class Wall>
concept SmoothWall = requires {
    typename SmoothHistory<Wall>::Type;
};

PairContact collide(const SrShape& a, const PlaneWall& wall, const SmoothCall& call);

/// A body flatter than the inside of a cylinder touches it in two places or more: all of them
/// together are one contact.
PairContact collide(const SrShape& a, const CylinderWall& wall,
                    const Call<PatchHistory, MissCache>& call);

}  // namespace dem::runtime
