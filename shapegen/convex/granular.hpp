// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/convex/rounding.hpp"
#include "shapegen/solids/make_convex.hpp"

#include <cstdint>
#include <optional>

/// Grains of which no two are the same [GC 8.1].
namespace dem::shapegen {

struct GranularOptions {
    enum class Kind { sand, woodchips };
    enum class Base { sphere, ellipsoid };  ///< that the corners of sand lie on
    Kind kind = Kind::sand;
    Base base = Base::sphere;
    /// Sand: diameter of the sphere on which the corners lie, or of the sphere of the ellipsoid's
    /// volume. Woodchips: their mean length; all other dimensions follow it. [m]
    double size = 5e-3;
    std::optional<Rounding> rounding;
    std::uint64_t seed = 1;
};

/// A polyhedron with its edges and corners rounded, around a core with as many vertices, of which
/// each lies below one of the polyhedron's; the core is then made a little larger, so that the
/// rounded body has the volume of the polyhedron.
struct Grain {
    ConvexSolid solid;
    DisplayMesh display_mesh;  ///< the polyhedron before it was rounded, body frame
    int redrawn = 0;           ///< slivers before this one
};

/// Grain `index` of a library: the same for any number of others. Sand: the hull of 5 to 20 random
/// points on the sphere or on a prolate ellipsoid of aspect ratio 3, which repelled each other for
/// a while. Woodchips: the hull of four points on each of two circles.
/// Slivers that the rounding does not fit into are drawn again: where a face lies less than twice
/// its radius from the center, or a corner would retreat by more than 10 % of d_eq. Throws Error
/// where that never ends.
Grain make_grain(const GranularOptions& options, std::uint64_t index);

}  // namespace dem::shapegen
