// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "common/shapes/sphere.hpp"
#include "runtime/contact/fields/node_contact.hpp"

namespace dem::runtime {

/// Two clumps, or a clump and a sphere: every pair of their spheres that overlap is a contact point
/// in the middle of the overlap, with the sphere of i and that of j as its feature; all act
/// together (contact_force for many points). R* is that of the deepest pair.
PairContact collide(const Clump& a, const Clump& b, const PatchCall& call);
PairContact collide(const Sphere& a, const Clump& b, const PatchCall& call);

}  // namespace dem::runtime
