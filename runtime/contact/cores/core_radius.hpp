// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

namespace dem::runtime {

/// R* of a pair with a convex shape [m]: half the diameter of the sphere of equal volume for every
/// shape but a sphere of its own. Which feature touches changes within a collision, and with it
/// curvature, from zero to that of the rounding (docs/contact-convex.md, "Effective radius").
struct ConvexRadius {
    double diameter_i, diameter_j;  ///< of the spheres of equal volume [m]; infinite: a wall

    double value() const { return 0.5 / (1.0 / diameter_i + 1.0 / diameter_j); }
};

}  // namespace dem::runtime
