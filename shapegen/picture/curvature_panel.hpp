// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/picture/cross_section_panel.hpp"

namespace dem::shapegen {

/// The mean curvature against the arc length, bottom to top. The scale follows the bulk of the
/// surface; what a sharp edge sticks out is cut and labeled.
void draw_curvature(SvgPage& page, const PanelBox& box, const SrShape& sr);

}  // namespace dem::shapegen
