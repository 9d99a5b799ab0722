// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/mass_properties.hpp"
#include "shapegen/profile/profile.hpp"

namespace dem::shapegen {

/// Everything a body of revolution of uniform density has by integration along its profile.
struct RevolutionMass {
    MassProperties mass_properties;              ///< principal axes = axes of the profile's frame
    double surface_area = 0.0;                   ///< [m^2]
    double mean_squared_surface_distance = 0.0;  ///< area-weighted, from the center of mass [m^2]
};

/// Volume, center of mass and moments by [SR] Eqs. 1-4, written as integrals along the profile so
/// that dimples need no care: closed form on lines, Gauss quadrature on arcs and curves, relative
/// error below 1e-12.
RevolutionMass revolution_mass(const Profile& profile);

}  // namespace dem::shapegen
