// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <algorithm>

namespace dem::runtime {

/// Mean curvature H of the surface [1/m] next to the point (r, z) of the half plane at which the
/// outward direction is (n_r, n_z), n_r >= 0, of any length > 0. A convex shape answers from its
/// support map in closed form, any other from the nearest point of its curvature table.
double mean_curvature_near(const SrShape& shape, double r, double z, double n_r, double n_z);

/// Curvature as it enters R*: 1/H kept within [0.01, 5] equivalent diameters (docs/contact.md,
/// "Effective radius"), so that edges, faces and hollows give finite stiffness.
inline double contact_curvature(double mean_curvature, double equivalent_diameter) {
    return std::clamp(mean_curvature, 0.2 / equivalent_diameter, 100.0 / equivalent_diameter);
}

/// R* of a place of the shape with this mean curvature [1/m] against a sphere [m].
inline double local_radius(const SrShape& shape, double mean_curvature, double sphere_radius) {
    return 1.0 /
           (contact_curvature(mean_curvature, shape.equivalent_diameter) + 1.0 / sphere_radius);
}

}  // namespace dem::runtime
