// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/convex/convex_file.hpp"
#include "shapegen/import/load_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dem::shapegen {

struct ConvexRequest {
    std::optional<Rounding> rounding;     ///< else the file's own or default_rounding()
    std::optional<std::size_t> vertices;  ///< of the core, for meshes
    bool keeps_volume = false;            ///< scales the core to the volume of the mesh
};

/// A template with what the user should know about its making.
struct CookedConvex {
    ParticleTemplate shape;
    std::uint64_t hash = 0;  ///< file_hash() of the file
    std::vector<std::string> lines;
};

/// True for files that hold convex shapes, by the extension.
bool is_convex_file(const std::filesystem::path& path);

/// Cooks a `.convex` file, a profile that is one of the convex shapes, or the hull of a mesh. Of a
/// mesh: the hull of the repaired surface, its planes moved inwards by the rounding, of this core
/// the vertices asked for, scaled about its center where the volume of the mesh is to be kept. The
/// certificate has, lengths in units of d_eq of the rounded body, volumes in units of what they are
/// compared with, all but the last two before anything is scaled:
///   rounding               radius of the sphere around the core
///   rounding_loss          of the sharp body's volume
///   corner_retreat         distance of the rounded body from the sharpest corner
///   facet_error_max        distance of facets from the curved surface they stand for (oblong)
///   hull_excess            volume that the hull adds to the mesh (meshes)
///   hull_error_max         distance of the farthest vertex left out (meshes)
///   hull_loss              volume that goes with the vertices left out (meshes)
///   core_scale             factor of the core's lengths, 1 where nothing is scaled (meshes)
///   display_mesh_error_max of the display mesh
/// Throws Error that begins with the path.
CookedConvex cook_convex(const std::filesystem::path& path, const ConvexRequest& request,
                         const MeshLoadOptions& mesh);

/// The template of a solid, without certificate and display mesh.
ParticleTemplate convex_template(ConvexSolid solid, std::string name);

}  // namespace dem::shapegen
