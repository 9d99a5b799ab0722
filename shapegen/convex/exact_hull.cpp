// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/exact_hull.hpp"

#include "shapegen/solids/hull_faces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>

namespace dem::shapegen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Index = std::uint32_t;

/// Number of each vertex: that of the first of the points that is there.
std::vector<Index> numbers(const Mesh& mesh, std::span<const Vec3> points) {
    std::map<std::array<double, 3>, Index> first;
    for (Index k = 0; k < points.size(); ++k)
        first.emplace(std::array{points[k].x(), points[k].y(), points[k].z()}, k);
    std::vector<Index> result;
    for (const Mesh::Vertex_index v : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(v);
        result.push_back(first.at({p.x(), p.y(), p.z()}));
    }
    return result;
}

}  // namespace

ConvexPolyhedron exact_hull(std::span<const Vec3> points) {
    require_points_of_hull(points);
    std::vector<Kernel::Point_3> input;
    for (const Vec3& p : points) input.emplace_back(p.x(), p.y(), p.z());
    Mesh mesh;
    CGAL::convex_hull_3(input.begin(), input.end(), mesh);
    if (mesh.number_of_faces() < 4 || !CGAL::is_closed(mesh)) fail_flat_hull(points.size());
    // Whatever the order in which CGAL finds them.
    const std::vector<Index> number = numbers(mesh, points);
    std::vector<std::array<Index, 3>> triangles;
    for (const Mesh::Face_index f : mesh.faces()) {
        std::array<Index, 3> triangle{};
        std::size_t k = 0;
        for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
            triangle[k++] = number[v.idx()];
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return polyhedron_of(points, triangles);
}

}  // namespace dem::shapegen
