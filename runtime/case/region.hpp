// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <optional>
#include <vector>

namespace dem::runtime {

/// Throws Error at the group's line when its region reaches behind a plane, a disc it stands in
/// front of, or the inside of a cylinder, where they are at the start of the insertion. Rods may
/// stand in a region. Likewise when it reaches out of the domain that the case gives.
void check_region(const InsertionGroup& group, const std::vector<Wall>& walls,
                  const std::optional<Aabb>& domain);

}  // namespace dem::runtime
