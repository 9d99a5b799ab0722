// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"

namespace dem {

/// A convex surface of revolution and a convex shape: the nearest points of the surface and of the
/// core. A surface of revolution has no straight parts (its flat ones are crowned), so that one
/// point is all.
PairContact collide(const SrShape& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory);
PairContact collide(const ConvexShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory);

/// Any surface of revolution with nodes and a convex shape: the nodes in the exact distance of the
/// shape.
PairContact collide(const SrShape& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory);
PairContact collide(const ConvexShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory);

}  // namespace dem
