// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Files for other programs: surfaces and nodes in the body frame, lengths in metres. Each is
/// written beside and renamed; throws Error when that fails.
namespace dem {

/// A surface with a number at each vertex, in any frame and unit.
struct ColoredMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<double> values;  ///< one per vertex
};

/// Binary STL, single precision; `name` goes into the header.
void write_stl(const std::filesystem::path& path, const DisplayMesh& mesh, const std::string& name);

/// The same of a surface in another unit, which goes into the header as well.
void write_stl(const std::filesystem::path& path, const ColoredMesh& mesh, const std::string& name,
               const std::string& unit);

/// VTK XML unstructured grid (ParaView, meshio), ASCII with digits that round trip exactly.
void write_vtu(const std::filesystem::path& path, const DisplayMesh& mesh);

/// Several surfaces in one file: `value_name` at the points, `part` (0, 1, ...) of the triangles.
void write_vtu(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               const std::string& value_name);

/// Wavefront OBJ, one object for each surface.
void write_obj(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               std::span<const std::string> names);

/// `x,y,z,mean_curvature` of each surface node, one row a node, a header row.
void write_nodes_csv(const std::filesystem::path& path, const SurfaceNodes& nodes);

}  // namespace dem
