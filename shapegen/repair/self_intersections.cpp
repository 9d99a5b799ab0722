// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/self_intersections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace dem {
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

}  // namespace

Finding self_intersections(const SurfaceMesh& mesh) {
    std::vector<std::pair<Face, Face>> pairs;
    pmp::self_intersections(mesh, std::back_inserter(pairs));
    std::erase_if(pairs, [&mesh](const auto& pair) {
        return touch_only_where_joined(mesh, pair.first, pair.second);
    });
    Finding finding{.what = "pairs of crossing triangles",
                    .treatment = "expected a surface that does not cross itself"};
    finding.count = pairs.size();
    if (!pairs.empty()) {
        const Face first = std::min_element(pairs.begin(), pairs.end())->first;
        finding.place = to_vec3(corners(mesh, first)[0]);
    }
    return finding;
}

std::vector<Finding> remove_self_intersections(SurfaceMesh& mesh, RepairReport& report) {
    Finding found = self_intersections(mesh);
    if (found.count == 0) return {};
    if (50 * found.count > mesh.number_of_faces()) return {found};
    const double before = CGAL::to_double(pmp::volume(mesh));
    pmp::experimental::remove_self_intersections(mesh);
    if (!CGAL::is_closed(mesh)) return {found};
    Finding left = self_intersections(mesh);
    if (left.count > 0) return {found};
    found.treatment = "cut out and closed anew";
    found.volume = std::abs(CGAL::to_double(pmp::volume(mesh)) - before);
    report.findings.push_back(found);
    return {};
}

}  // namespace dem
