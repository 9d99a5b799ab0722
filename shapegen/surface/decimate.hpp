// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <cstddef>

namespace dem::shapegen {

/// A mesh to look at in place of the solid's: edges collapsed by the quadrics of Garland and
/// Heckbert (1997) until at most `triangles` are left; a mesh that has no more stays as it is.
/// `max_deviation` is the largest distance found from the vertices of either surface to the other
/// one, and from the middles of the new edges and triangles.
DisplayMesh decimated(const SurfaceQuery& surface, std::size_t triangles);

}  // namespace dem::shapegen
