// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "shapegen/profile/profile.hpp"

namespace dem::shapegen {

/// Support map of a convex body of revolution (docs/contact.md, "Common normal"). Arcs of circles
/// and of axis-aligned ellipses are kept exactly, edges and tips become corners, free curves
/// tangent- continuous arc splines of at least 256 arcs per quarter, flat bands and end faces arcs
/// that turn by 4e-4 rad (crowned; less for flats longer than 0.6 l, so that no point moves more
/// than 3e-5 l). What a crown turns is taken from the neighbors' ranges of normals: from the corner
/// at its end, or from the end of a curve that joins it smoothly. The body must be convex
/// (convexity.hpp).
SupportMap support_map(const Profile& profile);

/// Largest difference between the map's support function and the profile's, over the normals of
/// dense samples of the profile and over the fans of its corners [m].
double support_error(const Profile& profile, const SupportMap& map);

}  // namespace dem::shapegen
