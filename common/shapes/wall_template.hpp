// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "common/shapes/wall_mesh.hpp"

#include <string>

namespace dem {

/// A wall as `shapegen --wall` cooked it.
struct WallTemplate {
    std::string name;
    /// What the numbers of the input are in [m], a scale included.
    double input_unit = 1.0;
    Certificate certificate;
    WallMesh mesh;
};

}  // namespace dem
