// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/profile/profile.hpp"

#include <vector>

namespace dem::shapegen {

/// Mean curvature H = (kappa_1 + kappa_2)/2 of the surface of revolution at a point of its profile,
/// in closed form from the profile's derivatives: kappa_1 of the profile, kappa_2 = n_r / r, at a
/// smooth pole kappa_2 = kappa_1 [1/m]. Positive where convex; not clamped, infinite at the tip of
/// a cone. Lines that meet at less than 10 deg stand for a curve: their turns are spread over them.
double mean_curvature(const Profile& profile, std::size_t segment, double t);

/// H kept to |1/H| >= 0.01 equivalent diameters, as templates store it: at an edge or a tip the
/// surface has no curvature radius, and a contact there must stay finite. The other limit,
/// 1/H <= 5 equivalent diameters, is applied at the contact: it has no sign.
double stored_mean_curvature(double mean_curvature, double equivalent_diameter);

/// H along the profile. A sharp edge is three samples at one arc length: the surface before it, the
/// clamp value, the surface after it.
struct CurvatureTable {
    std::vector<CurvatureSample> samples;
    /// Largest |interpolated - exact| between samples, relative to max(|H|, 0.2 / d_eq): the
    /// curvature below which contacts see the same radius.
    double largest_error = 0.0;
};

/// Samples no farther apart than 1/200 of the profile's length, and closer where linear
/// interpolation by arc length would be off by more than 1e-3 of max(|H|, 0.2 / d_eq).
CurvatureTable curvature_table(const Profile& profile, double equivalent_diameter);

}  // namespace dem::shapegen
