// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"

#include <string>

namespace dem::shapegen {

/// An SVG picture of a clump beside the body that it stands for, both colored by how far the clump
/// stands out of the body (red) or falls short of it (blue), seen along the axis of the largest
/// moment, tilted; below them what the judge measured.
std::string clump_picture(const ParticleTemplate& shape);

}  // namespace dem::shapegen
