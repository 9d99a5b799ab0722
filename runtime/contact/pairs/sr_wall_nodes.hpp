// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem {

/// The nodes of a surface of revolution against a wall primitive [SR] Sec. 2.4: for non-convex
/// shapes and for `contact = nodes`. Nodes beyond the rim of a disc or of the open end of a tube do
/// not touch. The wall's curvature does not enter R*.
PairContact collide(const SrShape& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory);

PairContact collide(const SrShape& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory);

}  // namespace dem
