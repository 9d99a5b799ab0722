// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_contact.hpp"

namespace dem::runtime {

/// Two surfaces of revolution, convex or not, by the nodes of i (the master) in the distance field
/// of j (the slave) [SR] Sec. 2.4. All touching nodes act together (contact_force for many points).
PairContact collide(const SrShape& a, const SrShape& b, const PatchCall& call);

}  // namespace dem::runtime
