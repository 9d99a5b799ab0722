// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh_tree.hpp"

namespace dem::shapegen {

/// Questions to the surface of a solid: nearest points, distances, inside or outside. Built once
/// per mesh; queries change nothing and may run in any number of threads.
class SurfaceQuery {
  public:
    /// The mesh is closed and outward (TriangleMesh); it is copied.
    explicit SurfaceQuery(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return mesh_; }

    /// The point of the surface nearest to p; of equally near triangles the one with the lowest
    /// index. Sooner for whoever knows that it is `within` a distance [m].
    SurfacePoint nearest(const Vec3& p,
                         double within = std::numeric_limits<double>::infinity()) const {
        return tree_.nearest(p, within);
    }

    /// The largest ball at q: TriangleMeshTree::tangent_radius.
    double tangent_radius(const Vec3& q, const Vec3& inward, double largest,
                          double touching) const {
        return tree_.tangent_radius(q, inward, largest, touching);
    }

    /// Unsigned distance to the surface [m], exact up to rounding.
    double distance(const Vec3& p) const { return tree_.nearest(p).distance; }

    /// True inside and on the surface. Exact: decided by exact predicates, also for rays through
    /// edges and corners. Where shells overlap, their union is inside.
    bool is_inside(const Vec3& p) const;

    /// Distance to the surface [m], negative inside.
    double signed_distance(const Vec3& p) const;

  private:
    TriangleMesh mesh_;
    TriangleMeshTree tree_;
};

}  // namespace dem::shapegen
