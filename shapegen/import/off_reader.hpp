// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace dem::shapegen {

/// The polygons of an OFF file of text: OFF, and with textures, colors or normals (STOFF, COFF,
/// NOFF and their combinations), which carry nothing for a shape. A line for each vertex and face.
/// Throws Error at NAME:LINE.
PolygonSoup read_off(std::span<const std::byte> bytes, const std::string& name);

}  // namespace dem::shapegen
