// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

namespace dem {

/// What follows from the pieces of a support map for the whole body, SupportMap::bounds.
SupportBounds support_bounds(const SupportMap& map);

}  // namespace dem
