// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"
#include "common/shapes/particle_template.hpp"

#include <array>
#include <cstdint>

/// Bodies to bounce: for every kind of shape that is computed in a way of its own, random members.
namespace dem::test {

enum class Kind : std::uint8_t {
    sphere,
    smooth,  ///< convex surfaces of revolution without edges
    sharp,   ///< the same with edges: cylinders, discs, tablets, frustums, double cones
    nodes,   ///< surfaces of revolution by their nodes
    clump,
    ellipsoid,  ///< convex, as the following
    polyhedron,
    cylinder,
    cone,
    plane,  ///< walls from here on
    tube,   ///< the inside of a cylinder
    rod,    ///< the outside, endless or with ends
};
inline constexpr std::array kinds = {
    Kind::sphere,     Kind::smooth,   Kind::sharp, Kind::nodes, Kind::clump, Kind::ellipsoid,
    Kind::polyhedron, Kind::cylinder, Kind::cone,  Kind::plane, Kind::tube,  Kind::rod};

inline bool is_wall(Kind kind) {
    return kind >= Kind::plane;
}
inline bool has_edges(Kind kind) {
    return kind == Kind::sharp || kind == Kind::polyhedron || kind == Kind::cylinder ||
           kind == Kind::cone;
}
const char* name(Kind kind);

/// One of a kind, aspect ratios from 0.3 to 3, about 4 to 10 mm across. Not for walls. `partner`:
/// clumps ask the distance field of a surface of revolution, which not all have here.
ParticleTemplate member(Kind kind, Kind partner, Random& random);

}  // namespace dem::test
