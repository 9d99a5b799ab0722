// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/mass_properties.hpp"

#include <cmath>

namespace dem {

double equivalent_diameter(double volume) {
    return std::cbrt(6.0 * volume / pi);
}

}  // namespace dem
