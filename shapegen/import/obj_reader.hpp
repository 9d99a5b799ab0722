// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace dem::shapegen {

/// The polygons of a Wavefront OBJ file. Indices may be absolute or relative, with or without those
/// of texture and normal; keywords of any case; lines joined by a backslash. Weights w of vertices
/// belong to free-form surfaces and do not move the corners of polygons. Names, groups, materials,
/// colors and normals carry nothing for a shape; points, lines and free-form elements are left out
/// with a note. Throws Error at NAME:LINE.
PolygonSoup read_obj(std::span<const std::byte> bytes, const std::string& name);

}  // namespace dem::shapegen
