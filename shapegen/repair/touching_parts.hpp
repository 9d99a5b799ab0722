// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

namespace dem::shapegen {

/// Gives bodies that meet in edges or corners points of their own there. At an edge of four or more
/// triangles those belong together that bound the same wedge of a body, which their order around
/// the edge and the ways they face tell; edges where these do not fit, and soups without such
/// edges, stay as they are. Points are shared by coordinates before.
void part_touching_bodies(TriangleSoup& soup, RepairReport& report);

/// True when the triangles, joined by the numbers of their corners alone, are two or more closed
/// surfaces, as programs write the parts of an assembly.
bool has_closed_parts(const TriangleSoup& soup);

}  // namespace dem::shapegen
