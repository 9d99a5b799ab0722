// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shared_array.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

/// Convex bodies as support mappings [GC 4.2]: a core and a sphere that rolls around it. Body
/// frame: origin at the center of mass of the rounded body, axes principal.
namespace dem {

/// A convex body: all points no farther than `rounding` from the core.
struct ConvexShape {
    enum class Core : std::uint32_t {
        polyhedron,  ///< hull of vertices; one vertex is a point, two are a segment
        ellipsoid,   ///< semi-axes `size`
        cylinder,    ///< about z, radius size.x, z from low to low + size.z; of height 0 a disc
        cone,        ///< about z, base of radius size.x at z = low, tip at z = low + size.z
    };
    /// Edge between two faces of a polyhedron; a segment has one of no face.
    struct Edge {
        static constexpr std::uint32_t no_face = ~std::uint32_t{0};
        std::uint32_t from, to;
        std::uint32_t left, right;  ///< faces, seen from outside on the way from -> to
        Vec3 direction;             ///< unit, from -> to
        double length;              ///< [m]
    };
    struct Plane {
        Vec3 normal;  ///< unit, outwards
        double offset;
    };

    Core core = Core::polyhedron;
    double rounding = 0.0;             ///< [m]
    StoredVec3 size;                   ///< of the core [m]; see Core
    double low = 0.0;                  ///< [m]
    double bounding_radius = 0.0;      ///< of the rounded body about the origin [m]
    double equivalent_diameter = 0.0;  ///< of the rounded body [m]

    // Polyhedra only.
    SharedArray<Vec3> vertices;                ///< [m]
    SharedArray<std::uint32_t> face_begin;     ///< faces + 1, into face_vertices
    SharedArray<std::uint32_t> face_vertices;  ///< counter-clockwise seen from outside

    // Follow from these (index_core) and are not stored in files.
    SharedArray<Plane> planes;                  ///< of the faces
    SharedArray<Edge> edges;                    ///< sorted by (from, to), from < to
    SharedArray<std::uint32_t> neighbor_begin;  ///< vertices + 1, into the next two
    SharedArray<std::uint32_t> neighbors;       ///< of a vertex along its edges, rising
    SharedArray<std::uint32_t> neighbor_edges;  ///< the edges to them

    std::size_t face_count() const { return planes.size(); }
    bool is_polyhedron() const { return core == Core::polyhedron; }
    /// Without flat or straight parts: two such bodies touch in one point only.
    bool is_strictly_convex() const {
        return core == Core::ellipsoid || (is_polyhedron() && vertices.size() == 1);
    }
};

/// Fills what follows from vertices and faces. Those must be of a closed polyhedron in which any
/// two vertices are joined along edges.
void index_core(ConvexShape& shape);

/// Whether index_core() can be called: closed, every edge of two faces, connected, Euler's relation
/// holds. Convexity is not asked for.
bool is_closed_hull(const ConvexShape& shape);

/// The vertex farthest along a direction, by climbing along edges from `start`. Among equals, any.
inline std::uint32_t farthest_vertex(const ConvexShape& shape, const Vec3& direction,
                                     std::uint32_t start) {
    double most = shape.vertices[start].dot(direction);
    for (;;) {
        std::uint32_t best = start;
        for (std::uint32_t k = shape.neighbor_begin[start]; k < shape.neighbor_begin[start + 1];
             ++k) {
            const std::uint32_t v = shape.neighbors[k];
            const double along = shape.vertices[v].dot(direction);
            if (along > most) {
                most = along;
                best = v;
            }
        }
        if (best == start) return start;
        start = best;
    }
}

/// A point of a core and, of a polyhedron, the vertex that it is.
struct CorePoint {
    Vec3 position;  ///< body frame [m]
    std::uint32_t vertex = 0;
};

/// The point of the core farthest along a direction of any length, [GC] Table 5; for the zero
/// vector some point. `start`: a vertex near it, where the climb begins.
inline CorePoint core_support(const ConvexShape& shape, const Vec3& direction,
                              std::uint32_t start = 0) {
    using Core = ConvexShape::Core;
    const StoredVec3& s = shape.size;
    if (shape.core == Core::polyhedron) {
        const std::uint32_t v = farthest_vertex(shape, direction, start);
        return {shape.vertices[v], v};
    }
    if (shape.core == Core::ellipsoid) {
        const Vec3 scaled(s.x * direction.x(), s.y * direction.y(), s.z * direction.z());
        const double length = scaled.norm();
        if (length == 0.0) return {{0.0, 0.0, s.z}};
        return {{s.x * scaled.x() / length, s.y * scaled.y() / length, s.z * scaled.z() / length}};
    }
    const double across2 = square(direction.x()) + square(direction.y());
    const double scale = across2 > 0.0 ? s.x / std::sqrt(across2) : 0.0;
    const Vec3 rim(scale * direction.x(), scale * direction.y(), shape.low);
    const double high = shape.low + s.z;
    if (shape.core == Core::cylinder)
        return {{rim.x(), rim.y(), direction.z() < 0.0 ? shape.low : high}};
    // A cone: the tip or the rim of its base.
    if (s.z * direction.z() > s.x * std::sqrt(across2)) return {{0.0, 0.0, high}};
    return {rim};
}

/// Largest unit direction . x over the rounded body [m].
inline double extent(const ConvexShape& shape, const Vec3& direction, std::uint32_t start = 0) {
    return core_support(shape, direction, start).position.dot(direction) + shape.rounding;
}

/// Distance of a point from a surface, negative inside, with its gradient: the unit vector away
/// from the nearest surface point.
struct SurfaceDistance {
    double distance;  ///< [m]
    Vec3 normal;
};

/// Distance of a point in the body frame from the surface of the rounded body, exact to rounding.
SurfaceDistance surface_distance(const ConvexShape& shape, const Vec3& x);

/// Distance of a point in the body frame from the surface of the core, without the rounding. For a
/// point farther than `beyond` [m] a lower bound that is no less than `beyond` will do.
SurfaceDistance core_distance(const ConvexShape& shape, const Vec3& x,
                              double beyond = std::numeric_limits<double>::infinity());

/// Distance of a point in the body frame from the surface of the core, a polyhedron with at least
/// two vertices of which it is known that the nearest point lies in one of these faces. For a point
/// farther than `beyond` [m] a lower bound that is no less than `beyond` will do.
SurfaceDistance distance_from_faces(const ConvexShape& shape, std::span<const std::uint32_t> faces,
                                    const Vec3& x, double beyond);

}  // namespace dem
