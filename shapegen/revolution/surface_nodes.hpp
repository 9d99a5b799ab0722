// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/revolution/rings.hpp"

#include <functional>
#include <span>

namespace dem::shapegen {

/// The points of the rings as surface nodes: ordered by recursive bisection along the widest side,
/// cut at whole blocks and super blocks so that both are compact; with smallest enclosing balls and
/// the 16 nearest other nodes of each (in rising distance). `mean_curvature` gives H of a ring
/// [1/m].
SurfaceNodes surface_nodes(std::span<const Ring> rings,
                           const std::function<double(const Ring&)>& mean_curvature);

}  // namespace dem::shapegen
