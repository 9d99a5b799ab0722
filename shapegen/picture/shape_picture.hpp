// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"

#include <string>

namespace dem::shapegen {

/// An SVG picture of a surface of revolution: its cross-section with the cells of the distance
/// field on the left of the axis and the surface nodes (seen from the front) on the right, and
/// beside it the mean curvature along the profile.
std::string shape_picture(const ParticleTemplate& shape, const SrShape& sr);

}  // namespace dem::shapegen
