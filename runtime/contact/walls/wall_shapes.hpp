// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <variant>

/// Walls as the contact kernels see them, each in its own frame. A `box` of the case file is six
/// planes, a cylinder's ends are discs: each flat or curved face is a contact partner of its own.
namespace dem {

/// The half space z < 0; the wall's origin lies on the plane. With a finite radius only the disc of
/// that radius about the origin acts, and only on bodies whose centre is in front of it.
struct PlaneWall {
    double radius = std::numeric_limits<double>::infinity();  ///< [m]
};

/// The side of a cylinder about the wall's z axis from z = 0 to z = length (infinite: both ways
/// without end). `inside`: bodies are kept within; otherwise the cylinder is a solid rod with flat
/// ends. An open end of a finite inside cylinder is a rim: bodies whose contact point lies beyond
/// it are not touched by the side. A vessel is closed by discs of more than its radius and a side
/// that reaches beyond them: a body pressed into the corner has contact points a little outside.
struct CylinderWall {
    double radius = 0.0;                                      ///< [m]
    double length = std::numeric_limits<double>::infinity();  ///< [m]
    bool inside = true;
};

using WallShape = std::variant<PlaneWall, CylinderWall>;

}  // namespace dem
