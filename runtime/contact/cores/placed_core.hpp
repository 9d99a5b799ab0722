// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"
#include "common/shapes/sphere.hpp"
#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/cores/gjk.hpp"
#include "runtime/contact/smooth/support_sample.hpp"

/// Cores at their places, as GJK and the features of a contact see them. A core offers
///
///     CorePoint support(direction, start)   the farthest point, and its vertex if it has any
///     double rounding                       of the sphere around the core [m]
///     double size                           bounding radius [m]
///     SupportKey key(point, vertex)         and Vec3 recalled(key), if has_keys
///
/// All vectors are in the world frame, relative to the center of i.
namespace dem::runtime {

struct PlacedCore {
    const ConvexShape& shape;
    Mat3 to_world;
    Vec3 center;  ///< [m]
    double rounding;
    double size;

    PlacedCore(const ConvexShape& s, const Quat& orientation, const Vec3& at)
        : shape(s),
          to_world(orientation.toRotationMatrix()),
          center(at),
          rounding(s.rounding),
          size(s.bounding_radius) {}

    Vec3 place(const Vec3& x_body) const { return center + to_world * x_body; }
    Vec3 turned(const Vec3& direction_body) const { return to_world * direction_body; }
    Vec3 in_body(const Vec3& x) const { return to_world.transpose() * (x - center); }
    Vec3 direction_in_body(const Vec3& direction) const { return to_world.transpose() * direction; }
    Vec3 vertex(std::uint32_t v) const { return place(shape.vertices[v]); }
    CorePoint support(const Vec3& direction, std::uint32_t start) const {
        CorePoint p = core_support(shape, direction_in_body(direction), start);
        p.position = place(p.position);
        return p;
    }
    static constexpr bool has_keys = true;
    SupportKey key(const Vec3& x, std::uint32_t vertex) const {
        if (shape.is_polyhedron()) return {vertex, {}};
        Vec3 towards = in_body(x);
        if (shape.core == ConvexShape::Core::ellipsoid) {
            const Vec3 axes = shape.size;
            towards = towards.cwiseQuotient(axes.cwiseProduct(axes));
        }
        return {0,
                {static_cast<float>(towards.x()), static_cast<float>(towards.y()),
                 static_cast<float>(towards.z())}};
    }
    Vec3 recalled(const SupportKey& k) const {
        if (shape.is_polyhedron()) return vertex(k.vertex);
        const auto& n = k.direction;
        return place(core_support(shape, Vec3(n[0], n[1], n[2])).position);
    }
    /// Whether its surface is made of points, edges and faces.
    bool has_vertices() const { return shape.is_polyhedron(); }
};

/// A sphere: a point with a rounding.
struct PlacedPoint {
    Vec3 center;
    double rounding;
    double size;

    PlacedPoint(const Sphere& sphere, const Vec3& at)
        : center(at), rounding(sphere.radius), size(sphere.radius) {}

    CorePoint support(const Vec3& /*direction*/, std::uint32_t /*start*/) const { return {center}; }
    static constexpr bool has_keys = true;
    static SupportKey key(const Vec3& /*x*/, std::uint32_t /*vertex*/) { return {}; }
    Vec3 recalled(const SupportKey& /*k*/) const { return center; }
    static bool has_vertices() { return true; }
};

/// A convex surface of revolution, which has no rounding of its own.
struct PlacedSr {
    SrSupport map;
    Vec3 center;
    double rounding = 0.0;
    double size;

    PlacedSr(const SrShape& shape, const Quat& orientation, const Vec3& at)
        : map{shape.support, body_axis(orientation)}, center(at), size(shape.bounding_radius) {}

    CorePoint support(const Vec3& direction, std::uint32_t /*start*/) const {
        const Vec3 n = direction.normalized();
        return {center + map(n).point(n)};
    }
    static constexpr bool has_keys = false;
    static bool has_vertices() { return false; }
};

}  // namespace dem::runtime
