// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/solids/make_convex.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"
#include "common/shapes/convex_moments.hpp"
#include "shapegen/solids/principal_axes.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

namespace dem::shapegen {

namespace {

using Core = ConvexShape::Core;
using Index = std::uint32_t;

void require_positive(double value, const char* name) {
    if (std::isfinite(value) && value > 0.0) return;
    std::ostringstream message;
    message << name << ' ' << value << " m, expected a positive number";
    throw Error("convex shape", message.str());
}

/// `room`: the largest radius of a sphere inside [m].
void require_rounding(double rounding, double room) {
    if (rounding >= 0.0 && rounding < room) return;
    std::ostringstream message;
    message << "rounding radius " << rounding << " m, expected zero or more and less than " << room
            << " m, the radius of the largest sphere inside";
    throw Error("convex shape", message.str());
}

double bounding_radius(const ConvexShape& shape) {
    const StoredVec3& s = shape.size;
    const double rim = math::hypot(s.x, shape.low);
    double core = 0.0;
    switch (shape.core) {
        case Core::polyhedron:
            for (const Vec3& v : shape.vertices) core = std::max(core, v.norm());
            break;
        case Core::ellipsoid:
            core = std::max({s.x, s.y, s.z});
            break;
        case Core::cylinder:
            core = std::max(rim, math::hypot(s.x, shape.low + s.z));
            break;
        case Core::cone:
            core = std::max(rim, std::abs(shape.low + s.z));
            break;
    }
    return core + shape.rounding;
}

/// Puts the body frame of the mass properties in place of the frame of the input.
void move_to_body_frame(ConvexShape& shape, const MassProperties& mass) {
    if (!shape.is_polyhedron()) {
        shape.low -= mass.center_of_mass.z();
        return;
    }
    const Mat3 to_body = mass.principal_axes.toRotationMatrix().transpose();
    std::vector<Vec3> vertices;
    for (const Vec3& v : shape.vertices) vertices.emplace_back(to_body * (v - mass.center_of_mass));
    shape.vertices = std::move(vertices);
    index_core(shape);
}

ConvexShape round_core(Core core, const Vec3& size, double low, double rounding) {
    ConvexShape shape;
    shape.core = core;
    shape.size = size;
    shape.low = low;
    shape.rounding = rounding;
    return shape;
}

ConvexSolid solid(ConvexShape shape, double sharp_volume) {
    ConvexSolid result = with_mass_properties(std::move(shape));
    if (result.shape.rounding > 0.0)
        result.rounding_loss = 1.0 - result.mass_properties.volume / sharp_volume;
    return result;
}

/// Vertices on the z axis at +- half: a point where half is zero.
ConvexSolid swept_sphere(double half, double radius) {
    ConvexShape shape;
    shape.rounding = radius;
    shape.vertices = half > 0.0 ? std::vector<Vec3>{{0.0, 0.0, -half}, {0.0, 0.0, half}}
                                : std::vector<Vec3>{Vec3::Zero()};
    index_core(shape);
    return with_mass_properties(std::move(shape));
}

}  // namespace

ConvexShape rounded_around(const ConvexPolyhedron& core, double rounding) {
    ConvexShape shape;
    shape.rounding = rounding;
    shape.vertices = core.vertices;
    std::vector<Index> begin{0};
    std::vector<Index> corners;
    for (const auto& face : core.faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        begin.push_back(static_cast<Index>(corners.size()));
    }
    shape.face_begin = std::move(begin);
    shape.face_vertices = std::move(corners);
    index_core(shape);
    return shape;
}

ConvexSolid with_mass_properties(ConvexShape shape) {
    const ConvexMoments m = convex_moments(shape);
    const Vec3 center = m.first / m.volume;
    const Mat3 about_center = m.second - m.volume * center * center.transpose();
    const Mat3 inertia = about_center.trace() * Mat3::Identity() - about_center;
    ConvexSolid result;
    result.mass_properties = principal_mass_properties(m.volume, center, inertia);
    if (!shape.is_polyhedron()) {
        // Already along the axes of the input.
        result.mass_properties.principal_axes = Quat::Identity();
        result.mass_properties.principal_moments_per_density = inertia.diagonal();
    }
    result.surface_area = m.area;
    result.mean_squared_surface_distance =
        (m.surface_second - 2.0 * center.dot(m.surface_first)) / m.area + center.squaredNorm();
    move_to_body_frame(shape, result.mass_properties);
    shape.bounding_radius = bounding_radius(shape);
    shape.equivalent_diameter = equivalent_diameter(m.volume);
    result.shape = std::move(shape);
    return result;
}

ConvexSolid make_convex_polyhedron(std::span<const Vec3> points, double rounding,
                                   const HullOfPoints& hull_of) {
    if (!(rounding >= 0.0)) require_rounding(rounding, std::numeric_limits<double>::infinity());
    ConvexPolyhedron hull = hull_of(points);
    // About a point inside: no differences of large moments.
    Vec3 origin = Vec3::Zero();
    for (const Vec3& v : hull.vertices) origin += v;
    origin /= static_cast<double>(hull.vertices.size());
    for (Vec3& v : hull.vertices) v -= origin;
    const double sharp = convex_moments(rounded_around(hull, 0.0)).volume;
    ConvexSolid result = solid(rounded_around(eroded(hull, rounding, hull_of), rounding), sharp);
    result.mass_properties.center_of_mass += origin;
    return result;
}

ConvexSolid make_cuboid(const Vec3& edge_lengths, double rounding) {
    for (int i = 0; i < 3; ++i) require_positive(edge_lengths[i], "edge length");
    require_rounding(rounding, 0.5 * edge_lengths.minCoeff());
    ConvexPolyhedron core;
    for (int k = 0; k < 8; ++k) {
        const Vec3 sign(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
        core.vertices.emplace_back(
            sign.cwiseProduct(edge_lengths - Vec3::Constant(2.0 * rounding)));
    }
    core.faces = {{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2},
                  {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
    return solid(rounded_around(core, rounding), edge_lengths.prod());
}

ConvexSolid make_cylinder(double radius, double height, double rounding) {
    require_positive(radius, "radius");
    require_positive(height, "height");
    require_rounding(rounding, std::min(radius, 0.5 * height));
    const double inner = height - 2.0 * rounding;
    return solid(round_core(Core::cylinder, {radius - rounding, radius - rounding, inner},
                            -0.5 * inner, rounding),
                 pi * square(radius) * height);
}

ConvexSolid make_cone(double radius, double height, double rounding) {
    require_positive(radius, "radius");
    require_positive(height, "height");
    // The largest sphere inside touches base and side.
    const double room = radius * height / (radius + math::hypot(radius, height));
    require_rounding(rounding, room);
    const double scale = 1.0 - rounding / room;
    const Vec3 size(scale * radius, scale * radius, scale * height);
    return solid(round_core(Core::cone, size, rounding, rounding),
                 pi / 3.0 * square(radius) * height);
}

ConvexSolid make_ellipsoid(const Vec3& semi_axes) {
    for (int i = 0; i < 3; ++i) require_positive(semi_axes[i], "semi-axis");
    return with_mass_properties(round_core(Core::ellipsoid, semi_axes, 0.0, 0.0));
}

ConvexSolid make_capsule(double radius, double length) {
    require_positive(radius, "radius");
    require_positive(length, "length");
    if (length < 2.0 * radius)
        throw Error("convex shape",
                    "a capsule shorter than twice its radius, expected a longer one");
    return swept_sphere(0.5 * length - radius, radius);
}

ConvexSolid make_rounded_disc(double radius, double thickness) {
    require_positive(radius, "radius");
    require_positive(thickness, "thickness");
    const double rounding = 0.5 * thickness;
    if (!(rounding < radius))
        throw Error("convex shape", "a disc thicker than twice its radius, expected a thinner one");
    const double inner = radius - rounding;
    return with_mass_properties(round_core(Core::cylinder, {inner, inner, 0.0}, 0.0, rounding));
}

ConvexSolid make_convex_sphere(double radius) {
    require_positive(radius, "radius");
    return swept_sphere(0.0, radius);
}

double farthest_outside(const ConvexSolid& solid, std::span<const Vec3> points) {
    const MassProperties& body = solid.mass_properties;
    double farthest = 0.0;
    for (const Vec3& p : points) {
        const Vec3 x = body.principal_axes.conjugate() * (p - body.center_of_mass);
        farthest = std::max(farthest, surface_distance(solid.shape, x).distance);
    }
    return farthest;
}

}  // namespace dem::shapegen
