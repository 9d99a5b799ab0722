// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/certificate/sdf_error.hpp"
#include "shapegen/profile/profile.hpp"
#include "shapegen/revolution/rings.hpp"

#include <span>

namespace dem::shapegen {

/// What cooking knows and the template does not keep.
struct CookingRecord {
    SdfError sdf;
    double curvature_error;       ///< CurvatureTable::largest_error
    std::span<const Ring> rings;  ///< of the surface nodes
};

/// What is known about the representation of a surface of revolution. In this order, lengths in
/// units of the major axis l:
///   sdf_error_mean, sdf_error_rms, sdf_error_max   interpolated against exact distance within one
///                                                  interface cell of the surface
///   sdf_gradient_angle_rms, sdf_gradient_angle_max the same of the gradient's direction [deg]
///   support_error_max        support function against the profile's (convex only)
///   curvature_error_max      of the curvature table between its samples (CurvatureTable)
///   node_spacing_mean, node_spacing_max   distance of a node to its nearest neighbor
///   node_surface_error_max   of the surface triangulated through the nodes
///   display_mesh_error_max   of the display mesh
///   volume_error             |volume - volume of revolved polygons, extrapolated| / volume
Certificate sr_certificate(const Profile& profile, const ParticleTemplate& shape, const SrShape& sr,
                           const CookingRecord& record);

/// Volume of the body by frustums through 2 n chords on each segment, extrapolated from n and 2 n
/// (Richardson); independent of the closed forms [m^3].
double polygon_volume(const Profile& profile, int n = 512);

}  // namespace dem::shapegen
