// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <filesystem>

namespace dem::shapegen {

/// The triangles of a glTF or GLB file, in meters, each mesh as often and where the nodes of the
/// scene place it. Coordinates pass through single precision. Read by assimp, in a process of its
/// own. Throws Error without the path.
PolygonSoup read_gltf(const std::filesystem::path& path);

}  // namespace dem::shapegen
