// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_template.hpp"

#include <string>

/// The ranges and the consistency that `demrun` relies on without looking again: every number
/// finite, every index inside its array, counts that match, bounding spheres that bound. Reader and
/// writer both call this, so that a template that was written can be read.
namespace dem {

/// "FILE: shape 3 'candy'", on one line whatever the name holds.
std::string shape_place(const std::string& where, std::size_t index, const std::string& name);

/// Throws Error, "WHERE: what was found, what was expected". Costs one pass over the arrays.
void check_template(const ParticleTemplate& shape, const std::string& where);

/// The part of a surface of revolution; `bounding_radius` [m] and `volume` [m^3] are the
/// template's.
void check_sr_shape(const SrShape& shape, double bounding_radius, double volume,
                    const std::string& where);

/// Whether the faces of a polyhedral core fit together, which index_core() relies on.
void check_convex_faces(const ConvexShape& shape, const std::string& where);

/// The part of a convex shape, its faces checked already.
void check_convex_shape(const ConvexShape& shape, double bounding_radius, double volume,
                        const std::string& where);

/// The part of a clump.
void check_clump(const Clump& clump, double bounding_radius, double volume,
                 const std::string& where);

/// The part of a wall that says where it is: indices inside their arrays, rings that close around
/// their edges, triangles with an area, boxes that hold them. What index_wall() fills is not looked
/// at.
void check_wall_mesh(const WallMesh& mesh, const std::string& where);

/// A wall, all of it.
void check_wall(const WallTemplate& wall, const std::string& where);

}  // namespace dem
