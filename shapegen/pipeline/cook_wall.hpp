// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/wall_template.hpp"
#include "shapegen/import/load_mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dem::shapegen {

struct WallRequest {
    double crease_angle = 0.0;  ///< [rad]
};

/// A wall with what the user should know about its making.
struct CookedWall {
    WallTemplate wall;
    std::uint64_t hash = 0;  ///< of the file
    std::vector<std::string> lines;
};

/// Makes a wall of all triangles of a mesh file, which stay where they are: nothing is closed, cut
/// or left out but triangles that repeat others. Triangles with an open edge are split where others
/// end in it, as far as rounding goes. Of the options only unit and scale are used. Throws Error
/// that begins with the path.
CookedWall cook_wall(const std::filesystem::path& path, const WallRequest& request,
                     const MeshLoadOptions& options);

}  // namespace dem::shapegen
