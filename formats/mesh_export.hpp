// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

#include <filesystem>
#include <string>

/// Files for other programs: surfaces and nodes in the body frame, lengths in metres. Each is
/// written beside and renamed; throws Error when that fails.
namespace dem {

/// Binary STL, single precision; `name` goes into the header.
void write_stl(const std::filesystem::path& path, const DisplayMesh& mesh, const std::string& name);

/// VTK XML unstructured grid (ParaView, meshio), ASCII with digits that round trip exactly.
void write_vtu(const std::filesystem::path& path, const DisplayMesh& mesh);

/// `x,y,z,mean_curvature` of each surface node, one row a node, a header row.
void write_nodes_csv(const std::filesystem::path& path, const SurfaceNodes& nodes);

}  // namespace dem
