// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <span>

namespace dem::shapegen {

/// The smallest ball that holds the points (at least one) [m]. Its radius is taken from the rounded
/// center, so every point is inside to the last bit.
SurfaceNodes::Ball enclosing_ball(std::span<const Vec3> points);

}  // namespace dem::shapegen
