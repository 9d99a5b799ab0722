// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

namespace dem::runtime {

/// The exact sphere that `radius = ...` of a particle group stands for; radius in m. Its display
/// mesh is an icosahedron divided twice (320 triangles).
ParticleTemplate sphere_template(double radius);

}  // namespace dem::runtime
