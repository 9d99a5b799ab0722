// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/wall_mesh.hpp"
#include "shapegen/repair/triangle_soup.hpp"

#include <cstddef>

namespace dem::shapegen {

/// What a surface that was made into a wall is like.
struct WallReport {
    std::size_t pieces = 0;     ///< that hang together by edges
    std::size_t rim_edges = 0;  ///< of one triangle only: none where the surface is closed
    std::size_t joints = 0;     ///< edges of more than two triangles
    std::size_t seams = 0;      ///< edges across which no fronts agree (a Moebius band has one)
    std::size_t turned = 0;     ///< triangles turned round so that fronts agree
    std::size_t repeated = 0;   ///< triangles left out because another has the same corners
    std::size_t convex = 0, concave = 0;  ///< edges that bend, seen from the front
    std::size_t creases = 0;              ///< of these more than the crease angle
    double area = 0.0;                    ///< [m^2]
};

struct MadeWall {
    WallMesh mesh;
    WallReport report;
};

/// Makes a wall of triangles in any order, of which corners in the same place are the same point
/// (share_points() in shapegen/repair/soup_cleaning.hpp). `crease_angle` [rad]. Throws Error: no
/// triangles, one without an area, a corner that is not a number.
MadeWall make_wall(const TriangleSoup& soup, double crease_angle);

}  // namespace dem::shapegen
