// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/picture/svg_page.hpp"

namespace dem::shapegen {

/// Where a panel lies on the page [px].
struct PanelBox {
    Vec2 corner, size;
};

/// The cross-section: outline, axis, center of mass, distance-field cells, nodes, scale bar,
/// legend.
void draw_cross_section(SvgPage& page, const PanelBox& box, const ParticleTemplate& shape,
                        const SrShape& sr);

}  // namespace dem::shapegen
