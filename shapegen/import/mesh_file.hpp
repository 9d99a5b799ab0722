// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/import/triangle_soup.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace dem {

/// What a mesh file holds, in its own coordinates.
struct MeshFile {
    TriangleSoup soup;
    std::string unit;                ///< the format's own ("m" for glTF), "" when it has none
    std::vector<std::string> notes;  ///< what was ignored: points, lines, the reader's warnings
};

/// True for the endings of the formats below, of any case.
bool is_mesh_file(const std::filesystem::path& path);

/// Reads STL (text, binary), OBJ, PLY, OFF, glTF and GLB, by the extension; polygons are split into
/// triangles, all objects of the file put together. Coordinates pass through single precision.
/// Throws Error: no such file, another format, broken content, no triangles, numbers that are not
/// finite.
MeshFile read_mesh_file(const std::filesystem::path& path);

}  // namespace dem
