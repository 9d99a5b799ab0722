// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/surface/decimate.hpp"

#include <algorithm>
#include <utility>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace dem::shapegen {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface cgal_mesh(const TriangleMesh& mesh) {
    Surface result;
    for (const Vec3& p : mesh.vertices) result.add_vertex({p.x(), p.y(), p.z()});
    const auto vertex = [](std::uint32_t i) { return Surface::Vertex_index(i); };
    for (const auto& [a, b, c] : mesh.triangles) result.add_face(vertex(a), vertex(b), vertex(c));
    return result;
}

TriangleMesh triangle_mesh(Surface& mesh) {
    mesh.collect_garbage();
    TriangleMesh result;
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        result.vertices.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto f : mesh.faces()) {
        const auto h = mesh.halfedge(f);
        result.triangles.push_back({static_cast<std::uint32_t>(mesh.source(h).idx()),
                                    static_cast<std::uint32_t>(mesh.target(h).idx()),
                                    static_cast<std::uint32_t>(mesh.target(mesh.next(h)).idx())});
    }
    return result;
}

double deviation(const SurfaceQuery& surface, const TriangleMesh& coarse) {
    double largest = 0.0;
    const auto measure = [&](const Vec3& p) { largest = std::max(largest, surface.distance(p)); };
    for (const Vec3& p : coarse.vertices) measure(p);
    for (const auto& [i, j, k] : coarse.triangles) {
        const Vec3& a = coarse.vertices[i];
        const Vec3& b = coarse.vertices[j];
        const Vec3& c = coarse.vertices[k];
        measure((a + b + c) / 3.0);
        measure(0.5 * (a + b));
        measure(0.5 * (b + c));
        measure(0.5 * (c + a));
    }
    const TriangleMeshTree tree(coarse);
    for (const Vec3& p : surface.mesh().vertices)
        largest = std::max(largest, tree.nearest(p).distance);
    return largest;
}

}  // namespace

DisplayMesh decimated(const SurfaceQuery& surface, std::size_t triangles) {
    namespace sms = CGAL::Surface_mesh_simplification;
    const TriangleMesh& mesh = surface.mesh();
    if (mesh.triangles.size() <= triangles) return {mesh.vertices, mesh.triangles, 0.0};
    Surface coarse = cgal_mesh(mesh);
    const std::size_t edges = 3 * triangles / 2;  // every triangle has half of three
    const sms::GarlandHeckbert_plane_policies<Surface, Kernel> quadrics(coarse);
    sms::edge_collapse(
        coarse, sms::Count_stop_predicate<Surface>(edges),
        CGAL::parameters::get_cost(quadrics.get_cost()).get_placement(quadrics.get_placement()));
    TriangleMesh result = triangle_mesh(coarse);
    const double largest = deviation(surface, result);
    return {std::move(result.vertices), std::move(result.triangles), largest};
}

}  // namespace dem::shapegen
