// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/fields/node_contact.hpp"

namespace dem::runtime {

/// A sphere and a surface of revolution that is not convex, or with `contact = nodes`.
///
/// A sphere that is small against the shape (radius <= SdfQuadtree::margin, 0.2 l for a non-convex
/// shape) touches where the shape is nearest to its center: the overlap is its radius minus the
/// distance field at its center, without any error from nodes. A larger one can touch a hollow on
/// all sides, where the nearest point alone would jump from side to side and never come to rest:
/// the shape's nodes inside the sphere act together instead. The choice depends on the two shapes
/// only, so a contact never changes from one to the other.
PairContact collide(const Sphere& a, const SrShape& b, const PatchCall& call);

}  // namespace dem::runtime
