// SPDX-License-Identifier: BSD-3-Clause
#include "common/math/elementary.hpp"
#include "common/shapes/convex_moments.hpp"
#include "formats/template_check.hpp"
#include "formats/value_check.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

using Core = ConvexShape::Core;

void check_dimensions(const ConvexShape& shape, const ValueCheck& check) {
    const StoredVec3& s = shape.size;
    check.not_negative(shape.rounding, "rounding of a convex shape");
    check.finite(shape.low, "lower end of a convex shape");
    switch (shape.core) {
        case Core::polyhedron:
            check.require(!shape.vertices.empty(), "a polyhedron has no vertices");
            check.require(shape.vertices.size() > 2 || shape.rounding > 0.0,
                          "a point or a segment has no rounding");
            return;
        case Core::ellipsoid:
            for (const double axis : {s.x, s.y, s.z}) check.positive(axis, "semi-axis");
            return;
        case Core::cylinder:
            check.positive(s.x, "radius of a cylinder");
            check.not_negative(s.z, "height of a cylinder");
            check.require(s.z > 0.0 || shape.rounding > 0.0, "a disc has no rounding");
            return;
        case Core::cone:
            check.positive(s.x, "radius of a cone");
            check.positive(s.z, "height of a cone");
            return;
    }
    check.require(false, "a convex shape has a core of an unknown kind");
}

/// Distance of the farthest surface point from the origin [m].
double farthest(const ConvexShape& shape) {
    const Vec3 size = shape.size;
    double core = 0.0;
    if (shape.is_polyhedron()) {
        for (const Vec3& v : shape.vertices) core = std::max(core, v.norm());
    } else if (shape.core == Core::ellipsoid) {
        core = size.maxCoeff();
    } else {
        const double top = shape.low + size.z();
        core = std::max(math::hypot(size.x(), shape.low),
                        shape.core == Core::cone ? std::abs(top) : math::hypot(size.x(), top));
    }
    return core + shape.rounding;
}

/// No vertex of a face lies above the plane of a neighbor: with a closed surface that is enough.
void check_convexity(const ConvexShape& shape, const ValueCheck& check) {
    const double slack = 1e-7 * shape.bounding_radius;
    const auto is_below = [&](std::uint32_t face, std::uint32_t other) {
        const ConvexShape::Plane& plane = shape.planes[other];
        for (std::uint32_t k = shape.face_begin[face]; k < shape.face_begin[face + 1]; ++k) {
            const Vec3& v = shape.vertices[shape.face_vertices[k]];
            if (!(plane.normal.dot(v) <= plane.offset + slack)) return false;
        }
        return true;
    };
    for (const ConvexShape::Edge& edge : shape.edges) {
        if (edge.left == ConvexShape::Edge::no_face) continue;
        check.require(is_below(edge.left, edge.right) && is_below(edge.right, edge.left),
                      "a polyhedron is not convex");
    }
}

}  // namespace

void check_convex_faces(const ConvexShape& shape, const std::string& where) {
    const ValueCheck check{where};
    check.require(static_cast<std::uint32_t>(shape.core) <= static_cast<std::uint32_t>(Core::cone),
                  "a convex shape has a core of an unknown kind");
    if (!shape.is_polyhedron()) {
        check.require(shape.vertices.empty() && shape.face_vertices.empty(),
                      "a convex shape that is no polyhedron has vertices");
        return;
    }
    for (const Vec3& v : shape.vertices) check.finite(v, "vertex of a polyhedron");
    const auto& begin = shape.face_begin;
    std::uint32_t last = 0;
    for (std::size_t f = 0; f < begin.size(); ++f) {
        check.require(f == 0 ? begin[0] == 0 : begin[f] >= last && begin[f] - last >= 3,
                      "a face of a polyhedron has fewer than three vertices");
        last = begin[f];
    }
    check.require(last == shape.face_vertices.size(),
                  "the faces of a polyhedron do not use up its list of vertices");
    for (const std::uint32_t v : shape.face_vertices) {
        check.require(v < shape.vertices.size(),
                      "a face of a polyhedron names a vertex that does not exist");
    }
    check.require(is_closed_hull(shape), "the faces of a polyhedron do not close");
}

void check_convex_shape(const ConvexShape& shape, double bounding_radius, double volume,
                        const std::string& where) {
    const ValueCheck check{where};
    check_dimensions(shape, check);
    const double reach = farthest(shape);
    check.require(reach <= check.slack * bounding_radius,
                  "a convex shape reaches beyond the bounding radius");
    check.require(bounding_radius <= 2.0 * reach,
                  "the bounding radius is more than twice the reach of the convex shape");
    if (shape.is_polyhedron()) check_convexity(shape, check);
    const ConvexMoments m = convex_moments(shape);
    check.require(std::abs(m.volume - volume) <= 1e-6 * volume,
                  "the volume is not that of the convex shape");
    check.require(m.first.norm() <= 1e-6 * volume * bounding_radius,
                  "the center of mass of the convex shape is not at the origin");
}

}  // namespace dem
