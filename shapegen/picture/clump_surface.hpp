// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/export/mesh_export.hpp"

#include <vector>

namespace dem::shapegen {

/// The spheres of a clump as triangles, those that lie inside another sphere left out, with the
/// distance of each vertex from the surface of the body's display mesh [m], positive outside: there
/// the clump stands out. All spheres together have at most about `most_triangles`. Body frame.
ColoredMesh clump_surface(const ParticleTemplate& shape, std::size_t most_triangles);

/// The display mesh of the body with minus the distance of each vertex from the nearest sphere [m]:
/// positive where the clump stands out, negative where it falls short. Body frame.
ColoredMesh body_surface(const ParticleTemplate& shape);

}  // namespace dem::shapegen
