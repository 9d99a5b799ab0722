// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "common/shapes/convex_shape.hpp"
#include "runtime/contact/fields/node_contact.hpp"

namespace dem::runtime {

/// A clump and a convex shape: the exact distance of the shape's surface at the centers of the
/// spheres; all spheres that touch act together. R* is that of the deepest.
PairContact collide(const Clump& a, const ConvexShape& b, const PatchCall& call);

}  // namespace dem::runtime
