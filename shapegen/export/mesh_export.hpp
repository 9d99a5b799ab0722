// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/export/input_frame.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Files for other programs: surfaces as they are given, nodes in the frame and unit of the input.
/// Each is written beside and renamed; throws Error when that fails.
namespace dem::shapegen {

/// A surface in any frame and unit, with a number at each vertex where there is something to show.
struct ColoredMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<double> values;  ///< one per vertex, or none
};

/// Binary STL, single precision; the name and the unit go into the header.
void write_stl(const std::filesystem::path& path, const ColoredMesh& mesh, const std::string& name,
               const std::string& unit);

/// VTK XML unstructured grid (ParaView, meshio), ASCII with digits that round trip exactly, of one
/// or more surfaces: `value_name` at the points unless it is "", and the number of the surface (0,
/// 1, ...) as `part` of its triangles where there are several.
void write_vtu(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               const std::string& value_name);

/// Wavefront OBJ, one object for each surface; the unit goes into a comment.
void write_obj(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               std::span<const std::string> names, const std::string& unit);

/// `x,y,z,mean_curvature` of each surface node, one row a node, a header row; curvatures in one
/// over the unit of length.
void write_nodes_csv(const std::filesystem::path& path, const SurfaceNodes& nodes,
                     const InputFrame& frame);

}  // namespace dem::shapegen
