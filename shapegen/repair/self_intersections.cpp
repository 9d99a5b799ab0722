// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/self_intersections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace dem::shapegen {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Face = SurfaceMesh::Face_index;
using Point = Kernel::Point_3;
using Corners = std::array<Point, 3>;

Corners corners(const SurfaceMesh& mesh, Face face) {
    const auto h = mesh.halfedge(face);
    return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
            mesh.point(mesh.target(mesh.next(h)))};
}

/// Moves the corners that both have to the front of both; returns their number.
std::size_t share(Corners& a, Corners& b) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found =
            std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
        if (found == b.end()) continue;
        std::swap(*found, b[shared]);
        std::swap(a[i], a[shared++]);
    }
    return shared;
}

/// CGAL knows of corners that two triangles share as vertices of the mesh; where the surface was
/// split, they only lie in one point.
bool touch_only_where_joined(const SurfaceMesh& mesh, Face first, Face second) {
    Corners a = corners(mesh, first);
    Corners b = corners(mesh, second);
    const std::size_t shared = share(a, b);
    if (shared == 2)
        return CGAL::orientation(a[0], a[1], a[2], b[2]) != CGAL::COPLANAR ||
               CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::NEGATIVE;
    if (shared != 1) return false;
    return !CGAL::do_intersect(Kernel::Triangle_3(a[0], a[1], a[2]),
                               Kernel::Segment_3(b[1], b[2])) &&
           !CGAL::do_intersect(Kernel::Triangle_3(b[0], b[1], b[2]), Kernel::Segment_3(a[1], a[2]));
}

using PartMap = SurfaceMesh::Property_map<Face, std::size_t>;

/// Whether each part of the surface is closed.
std::vector<bool> closed_parts(const SurfaceMesh& mesh, const PartMap& part_of, std::size_t parts) {
    std::vector<bool> is_closed(parts, true);
    for (const Face face : mesh.faces())
        for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(face), mesh))
            if (mesh.is_border(mesh.opposite(h))) is_closed[part_of[face]] = false;
    return is_closed;
}

void note(Finding& finding, const SurfaceMesh& mesh, Face face) {
    if (finding.count++ == 0) finding.place = to_vec3(corners(mesh, face)[0]);
}

}  // namespace

std::vector<CrossingPair> crossing_pairs(const SurfaceMesh& mesh) {
    std::vector<CrossingPair> pairs;
    const auto most = static_cast<unsigned>(20 * mesh.number_of_faces() + 1000);
    pmp::self_intersections(mesh, std::back_inserter(pairs),
                            CGAL::parameters::maximum_number(most));
    std::erase_if(pairs, [&mesh](const auto& pair) {
        return touch_only_where_joined(mesh, pair.first, pair.second);
    });
    for (auto& [first, second] : pairs)
        if (second < first) std::swap(first, second);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<Finding> SelfIntersections::findings() const {
    std::vector<Finding> result;
    for (const Finding& finding : {within, between})
        if (finding.count > 0) result.push_back(finding);
    return result;
}

SelfIntersections self_intersections(SurfaceMesh& mesh) {
    SelfIntersections result{crossing_pairs(mesh),
                             {.what = "pairs of crossing triangles",
                              .treatment = "expected a surface that does not cross itself"},
                             {.what = "pairs of triangles where closed parts cross or share a face",
                              .treatment = "expected parts that keep apart; --union joins them"}};
    if (result.pairs.empty()) return result;
    PartMap part_of = mesh.add_property_map<Face, std::size_t>("f:part").first;
    const std::vector<bool> is_closed =
        closed_parts(mesh, part_of, pmp::connected_components(mesh, part_of));
    for (const auto& [first, second] : result.pairs) {
        const std::size_t a = part_of[first];
        const std::size_t b = part_of[second];
        const bool is_between = a != b && is_closed[a] && is_closed[b];
        note(is_between ? result.between : result.within, mesh, first);
    }
    mesh.remove_property_map(part_of);
    return result;
}

std::vector<Finding> remove_self_intersections(SurfaceMesh& mesh, RepairReport& report) {
    const SelfIntersections found = self_intersections(mesh);
    if (found.between.count > 0 || 50 * found.within.count > mesh.number_of_faces())
        return found.findings();
    if (found.within.count == 0) return {};
    const double before = CGAL::to_double(pmp::volume(mesh));
    pmp::experimental::remove_self_intersections(mesh);
    if (!CGAL::is_closed(mesh) || !crossing_pairs(mesh).empty()) return found.findings();
    Finding removed = found.within;
    removed.treatment = "cut out and closed anew";
    removed.volume = std::abs(CGAL::to_double(pmp::volume(mesh)) - before);
    report.findings.push_back(removed);
    return {};
}

}  // namespace dem::shapegen
