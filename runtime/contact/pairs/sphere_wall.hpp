// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem::runtime {

/// A sphere against a wall (wall_shapes.hpp), which it touches in the point of the wall nearest to
/// its center. The wall's curvature does not enter R*.
template <AnyWall Wall>
PairContact collide(const Sphere& a, const Wall& wall, const SphereCall& call);

}  // namespace dem::runtime
