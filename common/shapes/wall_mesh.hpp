// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "common/math/types.hpp"
#include "common/shared_array.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

/// A wall made of triangles, as `shapegen --wall` cooked it: a surface that may be open or closed,
/// in one piece or in several, and is touched from both sides. Lengths in the frame of the input,
/// [m]. The front of a triangle is the side from which its corners run counter-clockwise; triangles
/// that share a smooth edge have their fronts on the same side.
///
/// Half edge 3 t + k is the edge of triangle t from its corner k to the next.
struct WallMesh {
    using Triangle = std::array<std::uint32_t, 3>;

    /// A box of the tree. Boxes lie in the order in which a walk down the tree meets them; the
    /// triangles of a leaf, and those below any box, follow one another.
    struct Box {
        Vec3 lower, upper;    ///< [m]
        std::uint32_t first;  ///< triangle
        std::uint32_t count;  ///< triangles of a leaf; 0: the box has boxes below it
        std::uint32_t next;   ///< box that follows when what is below this one is left out
        std::uint32_t spare = 0;
    };
    static constexpr std::uint32_t leaf_size = 4;

    SharedArray<Vec3> vertices;
    SharedArray<Triangle> triangles;
    /// The next half edge around the same edge, in a ring: itself at the rim of an open surface.
    SharedArray<std::uint32_t> twins;
    /// Angle between the normals of the two triangles at each half edge [rad], positive where the
    /// front bulges (convex), negative where it is hollow (concave). `sharp` at rims and where more
    /// than two triangles or triangles of different fronts meet.
    SharedArray<double> bends;
    static constexpr double sharp = pi;
    /// Triangles that are joined by edges which bend by no more than `crease_angle` have the same
    /// number, 0 <= patch < blends.size().
    SharedArray<std::uint32_t> patches;
    /// Per patch: over how large a difference in height the planes of neighboring triangles may be
    /// blended in its hollow edges without passing the middle of a triangle [m].
    SharedArray<double> blends;
    SharedArray<Box> boxes;
    double crease_angle = 0.0;  ///< [rad]

    // What index_wall() makes of the rest.
    std::vector<Vec3> normals;             ///< of the fronts, unit
    std::vector<std::uint32_t> fan_begin;  ///< vertices + 1: where each vertex begins in `fan`
    std::vector<std::uint32_t> fan;        ///< the vertices that share an edge with it, rising
    std::vector<double> least_bends;  ///< per patch, then of all: of smooth edges not level [rad]
    Aabb bounds;

    const Vec3& corner(std::uint32_t t, std::uint32_t k) const { return vertices[triangles[t][k]]; }
    bool is_smooth(std::uint32_t half_edge) const {
        return bends[half_edge] <= crease_angle && bends[half_edge] >= -crease_angle;
    }
};

/// Edges that bend by less are level: neighbors are one plane to what touches them [rad].
inline constexpr double level_bend = 0.005;

/// Fills what follows from the arrays, whose indices must be in range.
void index_wall(WallMesh& mesh);

/// The same wall with all lengths multiplied.
WallMesh scaled(const WallMesh& mesh, double scale);

/// What nearest_on_triangle() found: where, and on which part of the triangle.
struct TrianglePoint {
    Vec3 point;
    /// 0 to 2: that corner; 3 to 5: the inside of the edge that begins at corner part - 3; 6: the
    /// inside of the triangle.
    std::uint32_t part;

    static constexpr std::uint32_t inside = 6;
    bool is_corner() const { return part < 3; }
    bool is_edge() const { return part >= 3 && part < inside; }
};

/// The point of a triangle nearest to x (Ericson 2005, Sec. 5.1.5).
TrianglePoint nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x);

/// Squared distance of a point from a box; 0 inside.
inline double squared_distance(const WallMesh::Box& box, const Vec3& x) {
    return (box.lower - x).cwiseMax(x - box.upper).cwiseMax(0.0).squaredNorm();
}

/// Calls visit(t) for every triangle whose box is within `reach` of x, and some others near it, in
/// rising order.
template <class Visit>
void visit_near_triangles(const WallMesh& mesh, const Vec3& x, double reach, const Visit& visit) {
    const auto count = static_cast<std::uint32_t>(mesh.boxes.size());
    const double reach2 = square(reach);
    for (std::uint32_t b = 0; b < count;) {
        const WallMesh::Box& box = mesh.boxes[b];
        if (squared_distance(box, x) > reach2) {
            b = box.next;
            continue;
        }
        for (std::uint32_t t = box.first; t < box.first + box.count; ++t) visit(t);
        ++b;
    }
}

/// Distance of a point from the surface where that is less than `most`, else `most` [m].
double distance_within(const WallMesh& mesh, const Vec3& x, double most);

/// The first triangle, in the order of the mesh, that the segment from a to b crosses; the number
/// of triangles if there is none.
std::uint32_t first_crossed(const WallMesh& mesh, const Vec3& a, const Vec3& b);

}  // namespace dem
