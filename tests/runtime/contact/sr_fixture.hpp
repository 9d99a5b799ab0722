// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <vector>

/// Surfaces of revolution for tests that must not depend on `shapegen`: distance field, nodes and
/// curvature of a closely sampled outline. Plain and slow; no support map.
namespace dem::test {

/// Outlines in the half plane from the lower pole to the upper one, symmetric about z = 0 [m].
std::vector<Vec2> spheroid_outline(double equatorial, double polar, int samples = 1200);
/// Cassini oval |x - f||x + f| = b^2 about its long axis: waisted for f < b < sqrt(2) f.
std::vector<Vec2> peanut_outline(double f, double b, int samples = 1200);
/// The same about its short axis: dimpled at the poles.
std::vector<Vec2> red_blood_cell_outline(double f, double b, int samples = 1200);
/// Bi-convex tablet with sharp edges: band radius, band height, cap height.
std::vector<Vec2> tablet_outline(double band_radius, double band_height, double cap_height,
                                 int samples = 1200);

/// `nodes`: about how many. `sharp`: base cells that hold the outline's corners are refined to
/// l/800, other interface cells to l/200.
SrShape make_sr_shape(const std::vector<Vec2>& outline, bool is_convex, std::uint32_t nodes);

SrShape candy(std::uint32_t nodes = 2000);           ///< [SR] Sec. 4: 6.585, 3.395 mm
SrShape sharp_tablet(std::uint32_t nodes = 2000);    ///< [SR] Sec. 3.1: 5.675, 4.0, 1.23 mm
SrShape peanut(std::uint32_t nodes = 2000);          ///< waisted, 13 mm long
SrShape red_blood_cell(std::uint32_t nodes = 2000);  ///< dimpled, 13 mm across

}  // namespace dem::test
