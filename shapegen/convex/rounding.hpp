// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"

#include <string_view>

/// How much of the edges and corners of a convex shape is rounded off, as users say it.
namespace dem::shapegen {

struct Rounding {
    double value = 0.01;
    bool is_share = true;  ///< of d_eq, the diameter of the sphere of equal volume; else [m]

    /// For a body of this volume before it is rounded [m].
    double radius(double sharp_volume) const;
};

/// "1%" or a length: "0.1 mm", or a plain number in `unit` [m]; plain numbers are refused when
/// `unit` is zero. Throws Error without a place.
Rounding parse_rounding(std::string_view text, double unit);

/// What is taken where nothing is said: 1 % of d_eq, for thin bodies a quarter of the distance from
/// the center to the nearest face. `sharp`: not rounded.
double default_rounding(const ConvexShape& sharp, double volume);

}  // namespace dem::shapegen
