// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

namespace dem {

/// Geometry of a solid of uniform density; multiply by a density [kg/m^3] for masses.
struct MassProperties {
    double volume = 0.0;                                ///< [m^3]
    Vec3 center_of_mass = Vec3::Zero();                 ///< [m], in the frame of the input
    Quat principal_axes = Quat::Identity();             ///< body -> frame of the input
    Vec3 principal_moments_per_density = Vec3::Zero();  ///< [m^5], about body x, y, z
};

/// Diameter of the sphere of equal volume [m].
double equivalent_diameter(double volume);

}  // namespace dem
