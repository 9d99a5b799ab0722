// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace dem::shapegen {

/// The polygons and strips of triangles of a PLY file: text or binary of either byte order,
/// coordinates and indices of any type, other properties and elements passed over. In text each
/// element has its line. Throws Error at NAME:LINE or NAME: byte N.
PolygonSoup read_ply(std::span<const std::byte> bytes, const std::string& name);

}  // namespace dem::shapegen
