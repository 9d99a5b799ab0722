// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/convex/rounding.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/shapes/mass_properties.hpp"
#include "common/text.hpp"
#include "common/units.hpp"

#include <algorithm>

namespace dem::shapegen {

double Rounding::radius(double sharp_volume) const {
    return is_share ? value * equivalent_diameter(sharp_volume) : value;
}

Rounding parse_rounding(std::string_view text, double unit) {
    Rounding rounding;
    const auto number = finite_number(text);
    if (text.ends_with('%')) {
        rounding.value = finite_number(text.substr(0, text.size() - 1)).value_or(-1.0) / 100.0;
    } else if (number) {
        if (unit == 0.0)
            throw Error("found " + in_quotes(text) +
                        ", expected a length with its unit (0.1 mm) or a percentage of the "
                        "equivalent diameter (1%)");
        rounding = {*number * unit, false};
    } else {
        rounding = {parse_quantity(text, Dimension::length), false};
    }
    if (!(rounding.value >= 0.0))
        throw Error("found " + in_quotes(text) +
                    ", expected zero or more: a length (0.1 mm) or a percentage of the "
                    "equivalent diameter (1%)");
    return rounding;
}

double default_rounding(const ConvexShape& sharp, double volume) {
    double depth = 0.0;
    switch (sharp.core) {
        case ConvexShape::Core::polyhedron:
        case ConvexShape::Core::cylinder:
        case ConvexShape::Core::cone:
            depth = -surface_distance(sharp, Vec3::Zero()).distance;
            break;
        case ConvexShape::Core::ellipsoid:
            return 0.0;
    }
    return std::min(Rounding{}.radius(volume), 0.25 * depth);
}

}  // namespace dem::shapegen
