// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/meshes/mesh_touches.hpp"

/// Where a ball touches a surface of triangles (docs/mesh-walls.md, "Features").
namespace dem::runtime {

/// What a ball touches, gathered triangle by triangle in rising order.
class BallTouches : public MeshTouches {
  public:
    /// Center and radius of the ball [m], frame of the mesh; what the pair remembers of sides.
    BallTouches(const WallMesh& mesh, const Vec3& center, double radius, const MeshHistory& history,
                TouchedSides& sides)
        : MeshTouches(mesh, center, radius, history, sides) {}

    /// Adds what of triangle t is touched. Returns the distance of its nearest point [m].
    double add(std::uint32_t t);

  private:
    bool is_nearest(std::uint32_t t, const TrianglePoint& nearest) const;
    void join_sides(std::uint32_t t, const TrianglePoint& nearest);
};

}  // namespace dem::runtime
