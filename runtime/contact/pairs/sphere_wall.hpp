// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

/// A sphere against a wall primitive (wall_shapes.hpp). The wall's curvature does not enter R*.
namespace dem {

PairContact collide(const Sphere& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, PointHistory& history);

PairContact collide(const Sphere& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, PointHistory& history);

}  // namespace dem
