// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/solids/convex_polyhedron.hpp"

namespace dem::shapegen {

/// A mesh to look at: the hull of points on the surface of the rounded body, as many as keep it
/// within about `tolerance` [m] of the surface. `max_deviation` is how far the body rises above a
/// face, measured with the support mapping along the normals of all faces: between two normals the
/// distance of the surfaces is larger by the cosine of half their angle at most.
DisplayMesh convex_display_mesh(const ConvexShape& shape, double tolerance);

/// The faces of a polyhedron in triangles; `max_deviation` is left at zero.
DisplayMesh display_mesh(const ConvexPolyhedron& solid);

}  // namespace dem::shapegen
