// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/gjk.hpp"

#include <array>
#include <cstdint>

/// How deep two convex sets overlap, by the expanding polytope algorithm [GC 5.1], in a form that
/// needs no simplex around the origin to start from: a polytope inside the difference of the sets
/// grows where its faces have the least signed distance from the origin, negative where the origin
/// is still outside.
namespace dem {

struct Penetration {
    double depth = 0.0;           ///< least way that parts the sets [m]; negative: their distance
    Vec3 normal = Vec3::UnitZ();  ///< unit, from j towards i
    Vec3 point_i, point_j;        ///< the deepest points
    bool converged = false;       ///< the depth is exact to the tolerance asked for
};

/// A polytope with triangles, grown by one point after the other.
class ExpandingPolytope {
  public:
    static constexpr int most_points = 128;

    /// From four points; false when they lie in one plane.
    bool start(const std::array<SimplexPoint, 4>& points);
    struct Face {
        std::array<std::uint8_t, 3> point;
        Vec3 normal;    ///< outward
        double offset;  ///< signed distance from the origin [m]
        bool is_alive;
    };
    /// The face of least signed distance.
    const Face& nearest() const;
    /// Replaces all faces that see the point. False when it lies on the polytope, or there is no
    /// room: the polytope is then what it was.
    bool add(const SimplexPoint& p);
    /// The point of the face nearest to the origin on both sets.
    Penetration penetration(const Face& face) const;

  private:
    bool add_face(std::uint8_t a, std::uint8_t b, std::uint8_t c);

    static constexpr std::size_t most_faces = 4 * most_points;
    std::array<SimplexPoint, most_points> points_;
    std::array<Face, most_faces> faces_;
    std::size_t point_count_ = 0;
    std::size_t face_count_ = 0;
};

/// Four points of the difference that span as much as they can, of supports along six axes.
std::array<SimplexPoint, 4> widest(const std::array<SimplexPoint, 6>& supports);

/// `support(direction)`: the SimplexPoint of i - j farthest along a direction; `tolerance` of the
/// depth [m].
template <class Support>
Penetration penetration(const Support& support, double tolerance) {
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    const Vec3 z = Vec3::UnitZ();
    ExpandingPolytope polytope;
    if (!polytope.start(
            widest({support(x), support(-x), support(y), support(-y), support(z), support(-z)})))
        return {};
    for (;;) {
        const ExpandingPolytope::Face& face = polytope.nearest();
        const SimplexPoint p = support(face.normal);
        const bool is_exact = face.normal.dot(p.w) - face.offset <= tolerance;
        if (is_exact || !polytope.add(p)) {
            Penetration result = polytope.penetration(face);
            result.converged = is_exact;
            return result;
        }
    }
}

/// Of two cores.
template <class CoreI, class CoreJ>
Penetration core_penetration(const CoreI& i, const CoreJ& j) {
    const double tolerance = 1e-9 * (i.size + j.size);
    return penetration([&](const Vec3& n) { return gjk::support(i, j, n, 0, 0); }, tolerance);
}

}  // namespace dem
