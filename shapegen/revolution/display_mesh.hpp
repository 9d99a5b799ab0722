// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/profile/profile.hpp"

namespace dem::shapegen {

/// A closed triangle mesh of the body of revolution for pictures: the profile thinned to chords
/// (Douglas-Peucker), then revolved. Vertices lie on the surface, ring by ring from the bottom pole
/// to the top pole; the mesh leaves the surface by about `tolerance` [m], half of it along the
/// profile and half around the axis. `max_deviation` is measured with the exact distance.
DisplayMesh display_mesh(const Profile& profile, double tolerance);

}  // namespace dem::shapegen
