// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/holes.hpp"

#include <cmath>
#include <iterator>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

namespace dem::shapegen {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Face = SurfaceMesh::Face_index;
using Halfedge = SurfaceMesh::Halfedge_index;

/// A boundary cycle, closed for the estimates by a fan around the mean of its points.
struct Hole {
    Halfedge border;
    Vec3 place;
    double fan_volume;  ///< of the tetrahedra that the fan spans with the origin [m^3]
    double at_stake;    ///< a cap of 45 degrees on the area of the fan [m^3]
};

double tetrahedron_volume(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c)) / 6.0;
}

Hole measure(const SurfaceMesh& mesh, Halfedge border, const Vec3& origin) {
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (const auto h : CGAL::halfedges_around_face(border, mesh)) {
        sum += to_vec3(mesh.point(mesh.target(h)));
        count += 1.0;
    }
    const Vec3 middle = sum / count;
    Hole hole{border, middle, 0.0, 0.0};
    double area = 0.0;
    for (const auto h : CGAL::halfedges_around_face(border, mesh)) {
        const Vec3 a = to_vec3(mesh.point(mesh.source(h)));
        const Vec3 b = to_vec3(mesh.point(mesh.target(h)));
        area += 0.5 * (b - a).cross(middle - a).norm();
        hole.fan_volume += tetrahedron_volume(a - origin, b - origin, middle - origin);
    }
    // A cap of height h = r tan(45 deg / 2) on a circle of radius r: pi/6 h (3 r^2 + h^2).
    const double r = std::sqrt(area / pi);
    const double h = (std::sqrt(2.0) - 1.0) * r;
    hole.at_stake = pi / 6.0 * h * (3.0 * r * r + h * h);
    return hole;
}

/// A connected piece of the surface, its holes closed by fans.
struct Piece {
    double volume = 0.0;    ///< signed [m^3]
    double at_stake = 0.0;  ///< [m^3]
    bool is_open = false;
    Vec3 place = Vec3::Zero();
};

struct Pieces {
    SurfaceMesh::Property_map<Face, std::size_t> of_face;
    std::vector<Piece> pieces;
    std::vector<Hole> holes;
    double volume = 0.0;  ///< of all of them [m^3]
};

Pieces find_pieces(SurfaceMesh& mesh) {
    Pieces result;
    result.of_face = mesh.add_property_map<Face, std::size_t>("f:piece").first;
    result.pieces.resize(pmp::connected_components(mesh, result.of_face));
    const Vec3 origin = to_vec3(mesh.point(*mesh.vertices().begin()));
    for (const Face f : mesh.faces()) {
        const auto h = mesh.halfedge(f);
        const Vec3 a = to_vec3(mesh.point(mesh.source(h)));
        const Vec3 b = to_vec3(mesh.point(mesh.target(h)));
        const Vec3 c = to_vec3(mesh.point(mesh.target(mesh.next(h))));
        Piece& piece = result.pieces[result.of_face[f]];
        piece.volume += tetrahedron_volume(a - origin, b - origin, c - origin);
        piece.place = a;
    }
    std::vector<Halfedge> borders;
    pmp::extract_boundary_cycles(mesh, std::back_inserter(borders));
    for (const Halfedge border : borders) {
        const Hole hole = measure(mesh, border, origin);
        Piece& piece = result.pieces[result.of_face[mesh.face(mesh.opposite(border))]];
        piece.volume += hole.fan_volume;
        piece.at_stake += hole.at_stake;
        piece.is_open = true;
        result.holes.push_back(hole);
    }
    for (const Piece& piece : result.pieces) result.volume += std::abs(piece.volume);
    return result;
}

/// Removes open pieces that are too small to matter.
void remove_scraps(SurfaceMesh& mesh, const Pieces& found, double most, RepairReport& report) {
    Finding scraps{.what = "open scraps of surface", .treatment = "removed"};
    std::vector<std::size_t> to_remove;
    for (std::size_t p = 0; p < found.pieces.size(); ++p) {
        const Piece& piece = found.pieces[p];
        const double at_stake = std::abs(piece.volume) + piece.at_stake;
        if (!piece.is_open || at_stake > most) continue;
        if (scraps.count++ == 0) scraps.place = piece.place;
        scraps.volume += at_stake;
        to_remove.push_back(p);
    }
    if (to_remove.empty()) return;
    pmp::remove_connected_components(mesh, to_remove, found.of_face);
    report.findings.push_back(scraps);
}

Finding summary(const std::vector<Hole>& holes, const SurfaceMesh& mesh) {
    Finding finding{.what = "holes", .treatment = "closed"};
    double largest = -1.0;
    for (const Hole& hole : holes) {
        if (mesh.is_removed(hole.border)) continue;
        ++finding.count;
        finding.volume += hole.at_stake;
        if (hole.at_stake > largest) {
            largest = hole.at_stake;
            finding.place = hole.place;
        }
    }
    return finding;
}

}  // namespace

std::vector<Finding> close_holes(SurfaceMesh& mesh, double limit, RepairReport& report) {
    Pieces found = find_pieces(mesh);
    const double most = limit * found.volume;
    if (found.volume > 0.0) remove_scraps(mesh, found, most, report);
    mesh.remove_property_map(found.of_face);
    Finding holes = summary(found.holes, mesh);
    report.volume = found.volume;
    if (holes.count == 0) return {};
    if (!(found.volume > 0.0) || holes.volume > most) {
        holes.treatment = "expected a closed surface";
        if (found.volume > 0.0) holes.treatment += " or --repair-limit above that";
        return {holes};
    }
    Finding unfit{.what = "holes", .treatment = "no patch fits"};
    for (const Hole& hole : found.holes) {
        if (mesh.is_removed(hole.border)) continue;
        std::vector<Face> patch;
        pmp::triangulate_hole(mesh, hole.border, std::back_inserter(patch));
        if (patch.empty() && unfit.count++ == 0) unfit.place = hole.place;
    }
    if (unfit.count > 0) return {unfit};
    report.findings.push_back(holes);
    return {};
}

std::vector<Finding> remove_flat_triangles(SurfaceMesh& mesh, RepairReport& report) {
    std::vector<Face> flat;
    pmp::degenerate_faces(mesh, std::back_inserter(flat));
    if (flat.empty()) return {};
    Finding finding{"triangles without area", flat.size(),
                    to_vec3(mesh.point(mesh.target(mesh.halfedge(flat.front())))), "removed"};
    if (!pmp::remove_degenerate_faces(mesh)) {
        finding.treatment = "could not be removed";
        return {finding};
    }
    report.findings.push_back(finding);
    return {};
}

}  // namespace dem::shapegen
