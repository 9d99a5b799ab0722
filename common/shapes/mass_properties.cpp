// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/mass_properties.hpp"

#include "common/math/elementary.hpp"

namespace dem {

double equivalent_diameter(double volume) {
    return math::cbrt(6.0 * volume / pi);
}

}  // namespace dem
