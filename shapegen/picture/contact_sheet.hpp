// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"

#include <span>
#include <string>

namespace dem::shapegen {

inline constexpr std::size_t most_shapes_of_a_sheet = 25;

/// An SVG picture of up to 25 shapes side by side at one scale: their display meshes in parallel
/// projection, the body's z axis upwards, each with its name and its size.
std::string contact_sheet(std::span<const ParticleTemplate> shapes);

}  // namespace dem::shapegen
