// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_shape.hpp"

#include <algorithm>
#include <limits>

/// Distances from the cores of convex shapes, one function per kind of core.
namespace dem {

namespace {

using Index = std::uint32_t;

/// From the nearest point `p`, x outside.
SurfaceDistance from_point(const Vec3& x, const Vec3& p, const Vec3& otherwise) {
    const Vec3 away = x - p;
    const double distance = away.norm();
    return {distance, distance > 0.0 ? Vec3(away / distance) : otherwise};
}

Vec3 nearest_on_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double t = (x - a).dot(along) / along.squaredNorm();
    return a + std::clamp(t, 0.0, 1.0) * along;
}

/// Whether the projection of x to the plane of a face lies in the face; if not, `nearest` and its
/// squared distance `least` are taken over when an edge of the face is nearer.
bool is_above_face(const ConvexShape& shape, Index face, const Vec3& x, Vec3& nearest,
                   double& least) {
    const Index begin = shape.face_begin[face];
    const Index size = shape.face_begin[face + 1] - begin;
    const Vec3& normal = shape.planes[face].normal;
    bool is_inside = true;
    for (Index k = 0; k < size; ++k) {
        const Vec3& a = shape.vertices[shape.face_vertices[begin + k]];
        const Vec3& b = shape.vertices[shape.face_vertices[begin + (k + 1) % size]];
        if (normal.cross(b - a).dot(x - a) >= 0.0) continue;
        is_inside = false;
        const Vec3 p = nearest_on_segment(x, a, b);
        const double d2 = (x - p).squaredNorm();
        if (d2 < least) {
            least = d2;
            nearest = p;
        }
    }
    return is_inside;
}

SurfaceDistance from_segment(const ConvexShape& shape, const Vec3& x) {
    return from_point(x, nearest_on_segment(x, shape.vertices[0], shape.vertices[1]),
                      Vec3::UnitX());
}

/// The nearest of the faces number(0), number(1), ... The search ends where one of their planes
/// shows that x is farther than `beyond`.
template <class Number>
SurfaceDistance from_faces(const ConvexShape& shape, Index count, const Number& number,
                           const Vec3& x, double beyond) {
    double highest = -std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();
    double least = std::numeric_limits<double>::infinity();
    Vec3 nearest = Vec3::Zero();
    for (Index k = 0; k < count; ++k) {
        const Index f = number(k);
        const ConvexShape::Plane& plane = shape.planes[f];
        const double height = plane.normal.dot(x) - plane.offset;
        if (height >= beyond) return {height, plane.normal};
        if (height > highest) {
            highest = height;
            normal = plane.normal;
        }
        // The nearest point of a convex body lies in a face that x is in front of.
        if (height > 0.0 && is_above_face(shape, f, x, nearest, least))
            return {height, plane.normal};
    }
    if (highest <= 0.0) return {highest, normal};
    return from_point(x, nearest, normal);
}

SurfaceDistance from_polyhedron(const ConvexShape& shape, const Vec3& x) {
    if (shape.vertices.size() == 1) return from_point(x, shape.vertices[0], Vec3::UnitZ());
    if (shape.vertices.size() == 2) return from_segment(shape, x);
    return from_faces(
        shape, static_cast<Index>(shape.face_count()), [](Index f) { return f; }, x,
        std::numeric_limits<double>::infinity());
}

/// Position in a half plane through the z axis.
struct HalfPlanePoint {
    double r, z;
    Vec3 radial;  ///< unit; some direction on the axis

    explicit HalfPlanePoint(const Vec3& x)
        : r(std::sqrt(square(x.x()) + square(x.y()))), z(x.z()), radial(Vec3::UnitX()) {
        if (r > 0.0) radial = Vec3(x.x() / r, x.y() / r, 0.0);
    }
    Vec3 direction(double n_r, double n_z) const {
        return {n_r * radial.x(), n_r * radial.y(), n_z};
    }
};

SurfaceDistance from_cylinder(const ConvexShape& shape, const Vec3& x, double beyond) {
    const double high = shape.low + shape.size.z;
    const bool upper = x.z() > 0.5 * (shape.low + high);
    const double end = upper ? x.z() - high : shape.low - x.z();
    const double end_z = upper ? 1.0 : -1.0;
    if (end >= beyond) return {end, Vec3(0.0, 0.0, end_z)};
    const HalfPlanePoint p(x);
    const double side = p.r - shape.size.x;
    if (side >= beyond) return {side, p.direction(1.0, 0.0)};
    if (side > 0.0 && end > 0.0) {
        const double distance = std::sqrt(square(side) + square(end));
        return {distance, p.direction(side / distance, end_z * end / distance)};
    }
    if (side > end) return {side, p.direction(1.0, 0.0)};
    return {end, p.direction(0.0, end_z)};
}

SurfaceDistance from_cone(const ConvexShape& shape, const Vec3& x) {
    const HalfPlanePoint p(x);
    const double radius = shape.size.x;
    const double height = shape.size.z;
    const double z = p.z - shape.low;
    const double slant = std::sqrt(square(radius) + square(height));
    const double n_r = height / slant;
    const double n_z = radius / slant;
    const double above_side = n_r * (p.r - radius) + n_z * z;
    const double below_base = -z;
    if (above_side <= 0.0 && below_base <= 0.0) {
        if (above_side > below_base) return {above_side, p.direction(n_r, n_z)};
        return {below_base, p.direction(0.0, -1.0)};
    }
    // Along the side from the rim, 0 .. slant.
    const double s = (radius - p.r) * n_z + z * n_r;
    if (above_side > 0.0 && s >= 0.0 && s <= slant) return {above_side, p.direction(n_r, n_z)};
    if (below_base > 0.0 && p.r <= radius) return {below_base, p.direction(0.0, -1.0)};
    const double to_r = s > slant ? p.r : p.r - radius;
    const double to_z = s > slant ? z - height : z;
    const double distance = std::sqrt(square(to_r) + square(to_z));
    return {distance, p.direction(to_r / distance, to_z / distance)};
}

/// The root t > -min a^2 of sum (a_i x_i / (t + a_i^2))^2 = 1; the nearest point is
/// a_i^2 x_i / (t + a_i^2) (Eberly). The left side falls and is convex: Newton's method from the
/// left stays there.
double ellipsoid_root(const Vec3& a, const Vec3& x) {
    double t = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) t = std::max(t, a[i] * (std::abs(x[i]) - a[i]));
    for (int k = 0; k < 200; ++k) {
        double value = -1.0;
        double slope = 0.0;
        for (int i = 0; i < 3; ++i) {
            if (x[i] == 0.0) continue;
            const double denominator = t + a[i] * a[i];
            const double term = square(a[i] * x[i] / denominator);
            value += term;
            slope -= 2.0 * term / denominator;
        }
        const double next = t - value / slope;
        if (!(next > t)) return t;
        t = next;
    }
    return t;
}

SurfaceDistance from_ellipsoid(const ConvexShape& shape, const Vec3& x) {
    const Vec3 a = shape.size;
    const double shortest = a.minCoeff();
    // On the middle surface of the shortest axis the nearest point is one of two.
    double inside = 0.0;
    bool on_middle = true;
    int short_axis = 0;
    Vec3 nearest = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (a[i] == shortest) {
            on_middle = on_middle && std::abs(x[i]) < 1e-14 * shortest;
            short_axis = i;
        } else {
            nearest[i] = a[i] * a[i] * x[i] / (a[i] * a[i] - shortest * shortest);
            inside += square(nearest[i] / a[i]);
        }
    }
    if (on_middle && inside < 1.0) {
        nearest[short_axis] = shortest * std::sqrt(1.0 - inside);
    } else {
        const double t = ellipsoid_root(a, x);
        for (int i = 0; i < 3; ++i) nearest[i] = a[i] * a[i] * x[i] / (t + a[i] * a[i]);
    }
    const Vec3 normal = nearest.cwiseQuotient(a.cwiseProduct(a)).normalized();
    return {(x - nearest).dot(normal), normal};
}

}  // namespace

SurfaceDistance core_distance(const ConvexShape& shape, const Vec3& x, double beyond) {
    switch (shape.core) {
        case ConvexShape::Core::ellipsoid:
            return from_ellipsoid(shape, x);
        case ConvexShape::Core::cylinder:
            return from_cylinder(shape, x, beyond);
        case ConvexShape::Core::cone:
            return from_cone(shape, x);
        case ConvexShape::Core::polyhedron:
            break;
    }
    return from_polyhedron(shape, x);
}

SurfaceDistance distance_from_faces(const ConvexShape& shape, std::span<const Index> faces,
                                    const Vec3& x, double beyond) {
    if (shape.vertices.size() == 2) return from_segment(shape, x);
    return from_faces(
        shape, static_cast<Index>(faces.size()), [&](Index k) { return faces[k]; }, x, beyond);
}

SurfaceDistance surface_distance(const ConvexShape& shape, const Vec3& x) {
    SurfaceDistance d = core_distance(shape, x);
    d.distance -= shape.rounding;
    return d;
}

}  // namespace dem
