// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <filesystem>
#include <string>

namespace dem::shapegen {

/// What a mesh file holds, in its own coordinates.
struct MeshFile {
    PolygonSoup soup;
    std::string unit;  ///< the format's own ("m" for glTF), "" when it has none
};

/// ".stl, .obj, .ply, .off, .gltf or .glb"
std::string mesh_extensions();

/// True for these endings, of any case.
bool is_mesh_file(const std::filesystem::path& path);

/// Reads STL (text, binary), OBJ, PLY, OFF, glTF and GLB, by the extension; all objects of the file
/// are put together. Throws Error that begins with the path: no such file, another format, broken
/// content, no faces, numbers that are not finite.
MeshFile read_mesh_file(const std::filesystem::path& path);

}  // namespace dem::shapegen
