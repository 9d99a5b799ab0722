// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/clump/build_clump.hpp"
#include "shapegen/clump/mass_balance.hpp"

namespace dem::shapegen {

/// What the judge measured about a clump. In this order, lengths in units of the equivalent
/// diameter d_eq of the body, volumes in units of its volume:
///   coverage            of the body's volume by the union of the spheres
///   outside             volume of the union outside of the body
///   volume_ratio        volume of the union
///   rms_deviation       of the body's surface from the union
///   max_deviation_in    deepest gap between the body's surface and the union
///   max_deviation_out   how far the union reaches out of the body
///   moment_errors_x, _y, _z   of the union's moments about the body axes, relative
///   slope_rms           angle between the normals of body and union [deg]
///   ceiling             coverage that all candidate spheres reach together
///   components          number of pieces that do not touch each other
///   mass_tolerance      by which the moments of the spheres' masses differ from the body's
///   mass_product_tolerance    by which their products of inertia differ from 0, of the mean moment
///   mass_center_tolerance     by which their center differs along an axis
///   display_mesh_error_max    of the display mesh
Certificate clump_certificate(const BuiltClump& clump, const MassBalance& masses,
                              std::size_t components, double display_mesh_error);

}  // namespace dem::shapegen
