// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/mass_properties.hpp"

namespace dem::shapegen {

/// Mass properties from the tensor of inertia about the center of mass per density [m^5]. Of the
/// many names of the same axes those nearest to the axes of the input are taken (a mesh that is
/// aligned stays as it is), also among axes of equal moments (relative difference below 1e-9).
MassProperties principal_mass_properties(double volume, const Vec3& center_of_mass,
                                         const Mat3& inertia_per_density);

}  // namespace dem::shapegen
