// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

namespace dem::shapegen {

/// A sphere of a clump while it is being made, body frame [m].
struct Ball {
    Vec3 center = Vec3::Zero();
    double radius = 0.0;
};

}  // namespace dem::shapegen
