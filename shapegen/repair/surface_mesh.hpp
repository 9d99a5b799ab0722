// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

/// CGAL's mesh for the sources of shapegen/repair; no other folder includes this.
namespace dem::shapegen {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline Vec3 to_vec3(const Kernel::Point_3& p) {
    return {p.x(), p.y(), p.z()};
}

/// Without what was removed from the mesh; faces and vertices keep their order.
inline TriangleMesh triangle_mesh(SurfaceMesh& mesh) {
    mesh.collect_garbage();
    TriangleMesh result;
    result.vertices.reserve(mesh.number_of_vertices());
    for (const auto v : mesh.vertices()) result.vertices.push_back(to_vec3(mesh.point(v)));
    result.triangles.reserve(mesh.number_of_faces());
    for (const auto f : mesh.faces()) {
        const auto h = mesh.halfedge(f);
        const auto h1 = mesh.next(h);
        const auto h2 = mesh.next(h1);
        result.triangles.push_back({static_cast<std::uint32_t>(mesh.target(h).idx()),
                                    static_cast<std::uint32_t>(mesh.target(h1).idx()),
                                    static_cast<std::uint32_t>(mesh.target(h2).idx())});
    }
    return result;
}

}  // namespace dem::shapegen
