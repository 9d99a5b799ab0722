// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "runtime/contact/fields/node_contact.hpp"

namespace dem::runtime {

/// A clump and a surface of revolution; all contact points act together.
///
/// A convex shape: each sphere that touches it is a contact point on their common normal.
/// Any other: where the clump's spheres are small against the shape (radius <= SdfQuadtree::margin)
/// each touches where the shape is nearest to its center, by the distance field; otherwise the
/// nodes of the shape that lie inside the spheres act, as in sphere_sr_nodes.hpp and for its
/// reasons. The choice depends on the two shapes only.
PairContact collide(const Clump& a, const SrShape& b, const PatchCall& call);

}  // namespace dem::runtime
