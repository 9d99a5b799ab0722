// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

namespace dem::shapegen {

/// Keeps of triangles with equal corners one of those that face the way most do; none when
/// as many face one way as the other, for they enclose nothing: flaps, and faces that two parts
/// share. Where that would leave nothing at all, the body is drawn on both sides, and the first
/// triangle of each place is kept.
void remove_duplicates(TriangleSoup& soup, RepairReport& report);

}  // namespace dem::shapegen
