// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

/// Convex surfaces of revolution against wall primitives (wall_shapes.hpp), exact. The wall's
/// curvature does not enter R*.
namespace dem {

PairContact collide(const SrShape& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ContactMemory<PointHistory>& memory);

/// A body flatter than the inside of a cylinder touches it in two places or more: all of them
/// together are one contact.
PairContact collide(const SrShape& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ContactMemory<PatchHistory>& memory);

}  // namespace dem
