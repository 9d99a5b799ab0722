// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/clump/ball.hpp"
#include "shapegen/import/load_mesh.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace dem::shapegen {

/// A body that another shape is to stand for, from a mesh or a profile.
struct Solid {
    std::string name;
    std::uint64_t hash = 0;          ///< file_hash() of the file
    double unit = 1.0;               ///< of the file's numbers, times the scale [m]
    std::vector<std::string> lines;  ///< for the user: size, unit, repairs

    TriangleMesh mesh;  ///< body frame
    MassProperties mass_properties;
    double mean_squared_surface_distance = 0.0;  ///< [m^2]
    bool is_convex = false;
    std::shared_future<DisplayMesh> display_mesh;  ///< body frame; made meanwhile

    /// Where the body is a union of balls: those, in the body frame; else empty.
    std::vector<Ball> balls;
    double balls_deviation = 0.0;  ///< of their surface from the body's [m]
};

/// Reads a mesh or a profile. A mesh is repaired; a profile is revolved to a mesh that leaves its
/// surface by 2e-5 of the length of its major axis, all properties but the mesh being those of the
/// profile itself. Of the options, only the scale means something for a profile, which says its
/// unit itself and needs no repair. Throws Error that begins with the path.
Solid load_solid(const std::filesystem::path& path, const MeshLoadOptions& options);

}  // namespace dem::shapegen
