// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/shape_picture.hpp"

#include "common/units.hpp"
#include "shapegen/picture/cross_section_panel.hpp"
#include "shapegen/picture/curvature_panel.hpp"
#include "shapegen/picture/svg_page.hpp"

#include <cmath>

namespace dem::shapegen {

std::string shape_picture(const ParticleTemplate& shape, const SrShape& sr) {
    SvgPage page(1240.0, 720.0);
    const LengthUnit unit = length_unit(sr.major_axis_length);
    page.text({40, 42}, shape.name, 24, Anchor::start, true);
    page.text(
        {40, 66},
        std::string("surface of revolution, ") + (sr.is_convex ? "convex" : "not convex") +
            "; volume " + short_number(shape.mass_properties.volume / cube(unit.meters), 5) + " " +
            unit.name + "³, height " + short_number((sr.top_z - sr.bottom_z) / unit.meters, 4) +
            " " + unit.name + " between the poles, largest radius " +
            short_number(sr.max_radius / unit.meters, 4) + " " + unit.name + ", major axis l = " +
            short_number(sr.major_axis_length / unit.meters, 4) + " " + unit.name,
        14);
    draw_cross_section(page, {{40, 90}, {640, 610}}, shape, sr);
    draw_curvature(page, {{770, 120}, {430, 400}}, sr);
    return page.finish();
}

}  // namespace dem::shapegen
