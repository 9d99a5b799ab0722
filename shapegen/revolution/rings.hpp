// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"
#include "common/shapes/particle_template.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::shapegen {

/// Points on one circle of a surface of revolution: `count` of them, evenly spaced, the first at
/// the azimuth `phase` [rad]. A pole is a ring of one point.
struct Ring {
    double r, z;          ///< [m]
    std::size_t segment;  ///< of the profile, with the parameter t on it
    double t;
    std::uint32_t count;
    double phase;
};

/// The points of the rings, ring by ring [m].
std::vector<Vec3> ring_points(std::span<const Ring> rings);

/// Triangles between neighboring rings, counter-clockwise seen from outside; indices into
/// ring_points. The rings run from the bottom pole to the top pole, so the mesh is closed.
std::vector<std::array<std::uint32_t, 3>> ring_triangles(std::span<const Ring> rings);

/// Turns each ring by half its spacing against the one before, as in a close packing.
void stagger(std::span<Ring> rings);

}  // namespace dem::shapegen
