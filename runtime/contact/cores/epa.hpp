// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/gjk.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

/// How deep two convex sets overlap, by the expanding polytope algorithm [GC 5.1], in a form that
/// needs no simplex around the origin to start from: a polytope inside the difference of the sets
/// grows where its faces have the least signed distance from the origin, negative where the origin
/// is still outside.
namespace dem::runtime {

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
    /// Calls visit(normal) for every face.
    template <class Visit>
    void visit_normals(const Visit& visit) const {
        for (std::size_t f = 0; f < face_count_; ++f)
            if (faces_[f].is_alive) visit(faces_[f].normal);
    }
    /// The point of the face nearest to the origin on both sets.
    Penetration penetration(const Face& face) const;

  private:
    bool add_face(std::uint8_t a, std::uint8_t b, std::uint8_t c);

    static constexpr std::size_t most_faces = 4 * static_cast<std::size_t>(most_points);
    std::array<SimplexPoint, most_points> points_;
    std::array<Face, most_faces> faces_;
    std::size_t point_count_ = 0;
    std::size_t face_count_ = 0;
};

/// Four points of the difference that span as much as they can, of supports along six axes.
std::array<SimplexPoint, 4> widest(const std::array<SimplexPoint, 6>& supports);

/// Grows a polytope to the penetration. `support(direction)`: the SimplexPoint of i - j farthest
/// along a direction; `tolerance` of the depth [m].
template <class Support>
Penetration penetration(const Support& support, double tolerance, ExpandingPolytope& polytope) {
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    const Vec3 z = Vec3::UnitZ();
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

/// Least overlap downhill from a direction: i is moved out by what it overlaps along it and a gap
/// more. distance that is left is at least the gap, so that along its direction the
/// cores overlap by no more than before; where the gap is all that is left, that is the least.
template <class CoreI, class CoreJ>
Penetration parted(const CoreI& i, const CoreJ& j, const Vec3& start, double tolerance) {
    const double gap = 0.01 * std::min(i.size, j.size);
    constexpr int most = 64;
    const SimplexPoint deepest = gjk::support(i, j, -start, 0, 0);
    Penetration result{-start.dot(deepest.w), start, deepest.a, deepest.b, false};
    for (int k = 0; k < most && !result.converged; ++k) {
        const Vec3 n = result.normal;
        const Vec3 way = (gap - n.dot(gjk::support(i, j, -n, 0, 0).w)) * n;
        CoreI moved = i;
        moved.center += way;
        SearchStart from_there;
        from_there.direction = n;
        const CoreDistance left = core_distance(moved, j, from_there, 0.0);
        if (left.overlaps) break;
        result = {way.dot(left.normal) - left.distance, left.normal, left.point_i - way,
                  left.point_j, left.proven - gap <= tolerance};
    }
    return result;
}

/// Deepest penetration of two cores. Where many directions are nearly as good, on round cores,
/// rounding may fold the polytope: then the best of its normals is where parted() starts.
template <class CoreI, class CoreJ>
Penetration core_penetration(const CoreI& i, const CoreJ& j) {
    const double tolerance = 1e-11 * (i.size + j.size);
    const auto support = [&](const Vec3& n) { return gjk::support(i, j, n, 0, 0); };
    ExpandingPolytope polytope;
    Penetration result = penetration(support, tolerance, polytope);
    if (result.converged) return result;
    double least = std::numeric_limits<double>::infinity();
    Vec3 best = result.normal;
    polytope.visit_normals([&](const Vec3& n) {
        const double overlap = n.dot(support(n).w);
        if (n.squaredNorm() > 0.0 && overlap < least) {
            least = overlap;
            best = -n;
        }
    });
    return parted(i, j, best, tolerance);
}

}  // namespace dem::runtime
