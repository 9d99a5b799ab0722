// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/clump.hpp"

#include <cstddef>

namespace dem::shapegen {

/// The number of pieces that the spheres of a clump form: spheres that overlap or touch (to a
/// billionth of their radii) belong to one.
std::size_t component_count(const Clump& clump);

}  // namespace dem::shapegen
