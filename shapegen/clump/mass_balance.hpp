// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/mass_properties.hpp"
#include "shapegen/clump/ball.hpp"

#include <span>
#include <vector>

namespace dem::shapegen {

/// Masses per unit density that spheres get so that together they have the mass of the body, its
/// center and its inertia.
struct MassBalance {
    std::vector<double> shares;  ///< [m^3], one per ball, none negative
    /// The largest relative error of a moment that had to be allowed; 0 when all can be met.
    double tolerance = 0.0;
    /// The largest error of a product of inertia that had to be allowed, relative to the mean
    /// moment; 0 when all can be met.
    double product_tolerance = 0.0;
    /// How far off the center had to be, along each body axis [d_eq]; 0 but for a few spheres that
    /// do not surround it.
    double center_tolerance = 0.0;
};

/// Solves [MS Eqs. 5-8] in the body frame by linear programming (GLPK): mass, center and principal
/// moments of the body exactly, products of inertia zero, each sphere with its own 2/5 m r^2; the
/// least density of a sphere is made as large as possible, so that none is left nearly empty. Where
/// no masses do that, first the center, then the products, then the moments may be off by the least
/// tolerance that works.
MassBalance balance_masses(std::span<const Ball> balls, const MassProperties& body);

}  // namespace dem::shapegen
