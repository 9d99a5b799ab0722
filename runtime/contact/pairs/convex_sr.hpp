// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"

namespace dem::runtime {

/// A convex surface of revolution and a convex shape: the nearest points of the surface and of the
/// core. A surface of revolution has no straight parts (its flat ones are crowned), so that one
/// point is all.
PairContact collide(const SrShape& a, const ConvexShape& b, const CoreCall& call);

/// Any surface of revolution with nodes and a convex shape: the nodes in the exact distance of the
/// shape.
PairContact collide(const SrShape& a, const ConvexShape& b, const PatchCall& call);

}  // namespace dem::runtime
