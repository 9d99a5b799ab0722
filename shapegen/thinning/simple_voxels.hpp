// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/thinning/neighborhoods.hpp"

namespace dem::shapegen {

/// Which of the candidates are simple: taking one away changes neither the number of components nor
/// that of cavities or tunnels [MS Theorem 1].
Brick simple_voxels(const Neighborhoods& x, Brick candidates);

}  // namespace dem::shapegen
