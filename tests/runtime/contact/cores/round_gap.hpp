// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/placed_core.hpp"

#include <cmath>
#include <limits>

/// The distance of two cores that are apart, at least one of them round, by everything they can
/// meet with: all edges and rims, point by point, the axes of cylinders, an ellipsoid over a face.
/// Points on edges and rims are found by bisection of a slope, so that the distance is exact to
/// rounding.
namespace dem::test {

using namespace runtime;

class RoundGap {
  public:
    RoundGap(const PlacedCore& i, const PlacedCore& j) {
        add_lines(i, j, 1.0);
        add_lines(j, i, -1.0);
        if (is_cylinder(i) && is_cylinder(j)) add_sides(i, j);
    }
    /// Along the unit normal from j towards i.
    const SurfaceDistance& least() const { return least_; }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr int arcs = 180;  ///< that a rim is cut into

    static bool is_cylinder(const PlacedCore& c) {
        return c.shape.core == ConvexShape::Core::cylinder;
    }

    void offer(const SurfaceDistance& d) {
        if (d.distance < least_.distance) least_ = d;
    }

    /// Where the distance of a body from the points of a line is least between two of them: x(t)
    /// and its derivative.
    template <class Point, class Tangent>
    void descend(const PlacedCore& body, double sign, double low, double high, const Point& x,
                 const Tangent& tangent) {
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            const Vec3 away =
                body.turned(core_distance(body.shape, body.in_body(x(middle))).normal);
            (away.dot(tangent(middle)) > 0.0 ? high : low) = middle;
        }
        const SurfaceDistance d = core_distance(body.shape, body.in_body(x(low)));
        offer({d.distance, sign * body.turned(d.normal)});
    }

    /// The edges, rims and faces of one core against another.
    void add_lines(const PlacedCore& core, const PlacedCore& other, double sign) {
        for (const ConvexShape::Edge& e : core.shape.edges) {
            const Vec3 from = core.vertex(e.from);
            const Vec3 along = core.vertex(e.to) - from;
            descend(
                other, sign, 0.0, 1.0, [&](double t) { return Vec3(from + t * along); },
                [&](double) { return along; });
        }
        if (is_cylinder(core)) {
            add_rim(core, core.shape.low, other, sign);
            add_rim(core, core.shape.low + core.shape.size.z, other, sign);
        }
        if (other.shape.core == ConvexShape::Core::ellipsoid) add_faces(core, other, sign);
    }

    void add_rim(const PlacedCore& core, double z, const PlacedCore& other, double sign) {
        const double radius = core.shape.size.x;
        const auto x = [&](double angle) {
            return core.place({radius * std::cos(angle), radius * std::sin(angle), z});
        };
        const auto tangent = [&](double angle) {
            return core.turned({-std::sin(angle), std::cos(angle), 0.0});
        };
        const auto height = [&](int k) {
            return core_distance(other.shape, other.in_body(x(2.0 * pi * k / arcs))).distance;
        };
        double before = height(-1);
        double here = height(0);
        for (int k = 0; k < arcs; ++k) {
            const double after = height(k + 1);
            if (here <= before && here <= after)
                descend(other, sign, 2.0 * pi * (k - 1) / arcs, 2.0 * pi * (k + 1) / arcs, x,
                        tangent);
            before = here;
            here = after;
        }
    }

    /// The lowest point of an ellipsoid over each face that it lies above.
    void add_faces(const PlacedCore& core, const PlacedCore& ellipsoid, double sign) {
        for (const ConvexShape::Plane& face : core.shape.planes) {
            const Vec3 n = core.turned(face.normal);
            const Vec3 x = ellipsoid.support(-n, 0).position;
            const SurfaceDistance d = core_distance(core.shape, core.in_body(x));
            offer({d.distance, -sign * core.turned(d.normal)});
        }
    }

    /// The nearest points of two axes, if both lie between the ends.
    void add_sides(const PlacedCore& i, const PlacedCore& j) {
        const Vec3 u = i.turned(Vec3::UnitZ());
        const Vec3 w = j.turned(Vec3::UnitZ());
        const Vec3 from_i = i.place({0.0, 0.0, i.shape.low});
        const Vec3 r = j.place({0.0, 0.0, j.shape.low}) - from_i;
        const Vec3 across = u.cross(w);
        const double square_sine = across.squaredNorm();
        if (square_sine < 1e-12) return;
        const double s = r.cross(w).dot(across) / square_sine;
        const double t = r.cross(u).dot(across) / square_sine;
        if (s < 0.0 || s > i.shape.size.z || t < 0.0 || t > j.shape.size.z) return;
        const Vec3 gap = s * u - t * w - r;
        const double distance = gap.norm() - i.shape.size.x - j.shape.size.x;
        offer({distance, gap.normalized()});
    }

    SurfaceDistance least_{infinity, Vec3::UnitZ()};
};

}  // namespace dem::test
