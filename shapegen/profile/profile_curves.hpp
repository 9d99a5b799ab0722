// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_segment.hpp"

#include <array>

/// The free curves of named shapes and of the profile file. Lengths in meters.
namespace dem::shapegen {

/// Half profile of (r/a)^m + (|z|/c)^m = 1, m > 1, bottom to top, as a lower and an upper quarter
/// ([SR] Sec. 1: e = 1, n = 2/m).
std::array<ProfileSegment, 2> superquadric_quarters(double a, double c, double m);

/// Half profile, bottom to top, of the Cassini oval with foci at z = +- focus: the product of the
/// distances from the foci is product_root^2, product_root > focus. Dimpled at the waist (a peanut)
/// when product_root < sqrt(2) focus.
ProfileSegment cassini_half(double focus, double product_root);

/// Half profile, bottom to top, of a red blood cell (Evans & Fung 1972): with x = 2 r / diameter
/// the thickness is sqrt(1 - x^2) (c0 + c1 x^2 + c2 x^4).
ProfileSegment red_blood_cell_half(double diameter, const std::array<double, 3>& c);

/// Cubic Bezier curve.
ProfileSegment cubic_bezier(const std::array<Vec2, 4>& control_points);

}  // namespace dem::shapegen
