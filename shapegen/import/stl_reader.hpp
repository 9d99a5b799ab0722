// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace dem::shapegen {

/// The triangles of an STL file, text or binary, of one solid or several. Binary is what has the
/// size that its number of triangles asks for, whatever it begins with; bytes after the last
/// triangle are passed over with a note. Normals, names, colors and attributes carry nothing for a
/// shape. Throws Error at NAME:LINE or NAME: byte N.
PolygonSoup read_stl(std::span<const std::byte> bytes, const std::string& name);

}  // namespace dem::shapegen
