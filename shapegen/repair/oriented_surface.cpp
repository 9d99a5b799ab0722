// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/oriented_surface.hpp"

#include <algorithm>
#include <cstddef>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

namespace dem::shapegen {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Polygon = std::array<std::size_t, 3>;
using Points = std::vector<Kernel::Point_3>;

/// True when the corners run the other way round. `after` may name split points, which lie where
/// the originals are.
bool is_turned(const std::array<std::uint32_t, 3>& before, const Polygon& after,
               const Points& points) {
    const auto is_at = [&points](std::size_t a, std::size_t b) { return points[a] == points[b]; };
    std::size_t k = 0;
    while (k < 2 && !is_at(after[k], before[0])) ++k;
    return !is_at(after[(k + 1) % 3], before[1]);
}

/// Turns pieces that were made to follow a minority; reports the minorities.
void follow_majorities(SurfaceMesh& mesh, const std::vector<bool>& turned, RepairReport& report) {
    auto piece = mesh.add_property_map<SurfaceMesh::Face_index, std::size_t>("f:piece").first;
    const std::size_t pieces = pmp::connected_components(mesh, piece);
    std::vector<std::size_t> faces(pieces, 0);
    std::vector<std::size_t> turned_faces(pieces, 0);
    for (const auto f : mesh.faces()) {
        ++faces[piece[f]];
        if (turned[f.idx()]) ++turned_faces[piece[f]];
    }
    Finding finding{.what = "triangles facing against their neighbors", .treatment = "turned"};
    std::vector<SurfaceMesh::Face_index> to_turn;
    for (const auto f : mesh.faces()) {
        const std::size_t p = piece[f];
        const bool is_reversed = 2 * turned_faces[p] > faces[p];
        if (is_reversed) to_turn.push_back(f);
        if (turned[f.idx()] == is_reversed) continue;
        if (finding.count++ == 0)
            finding.place = to_vec3(mesh.point(mesh.target(mesh.halfedge(f))));
    }
    pmp::reverse_face_orientations(to_turn, mesh);
    mesh.remove_property_map(piece);
    if (finding.count > 0) report.findings.push_back(finding);
}

}  // namespace

SurfaceMesh oriented_surface(const TriangleSoup& soup, RepairReport& report) {
    Points points;
    points.reserve(soup.points.size());
    for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
    std::vector<Polygon> polygons;
    polygons.reserve(soup.triangles.size());
    for (const auto& [i, j, k] : soup.triangles) polygons.push_back({i, j, k});

    pmp::orient_polygon_soup(points, polygons);
    if (points.size() > soup.points.size())
        report.add({"points where surfaces meet in a corner or an edge",
                    points.size() - soup.points.size(), to_vec3(points[soup.points.size()]),
                    "split"});
    std::vector<bool> turned(polygons.size());
    for (std::size_t t = 0; t < polygons.size(); ++t)
        turned[t] = is_turned(soup.triangles[t], polygons[t], points);

    SurfaceMesh mesh;
    pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    follow_majorities(mesh, turned, report);
    // Piece by piece first: at an edge of four triangles only that tells which belong together.
    pmp::stitch_borders(mesh, CGAL::parameters::apply_per_connected_component(true));
    pmp::stitch_borders(mesh);
    return mesh;
}

}  // namespace dem::shapegen
