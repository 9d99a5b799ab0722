// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/face_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

namespace dem::shapegen {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Outline = std::vector<std::uint32_t>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// The outline seen along the axis that it faces most, counter-clockwise.
std::vector<Point2> flattened(const Outline& outline, const std::vector<Vec3>& points) {
    Vec3 normal = Vec3::Zero();  // Newell's sum
    const Vec3& origin = points[outline[0]];
    for (std::size_t k = 1; k + 1 < outline.size(); ++k)
        normal += (points[outline[k]] - origin).cross(points[outline[k + 1]] - origin);
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Eigen::Index x = (axis + 1) % 3;
    Eigen::Index y = (axis + 2) % 3;
    if (normal[axis] < 0.0) std::swap(x, y);
    std::vector<Point2> flat;
    for (const std::uint32_t corner : outline)
        flat.emplace_back(points[corner][x], points[corner][y]);
    return flat;
}

/// Which of the two diagonals to cut a face of four corners along: 0 from the first corner, 1 from
/// the second; nothing when neither lies inside.
std::optional<int> diagonal(const Outline& quad, const std::vector<Vec3>& points) {
    const std::vector<Point2> p = flattened(quad, points);
    const auto turns_left = [&p](std::size_t a, std::size_t b, std::size_t c) {
        return CGAL::orientation(p[a], p[b], p[c]) == CGAL::LEFT_TURN;
    };
    const bool first = turns_left(0, 1, 2) && turns_left(0, 2, 3);
    const bool second = turns_left(1, 2, 3) && turns_left(1, 3, 0);
    const auto length2 = [&](std::size_t a, std::size_t b) {
        return (points[quad[a]] - points[quad[b]]).squaredNorm();
    };
    if (first && second) return length2(0, 2) <= length2(1, 3) ? 0 : 1;
    if (first || second) return first ? 0 : 1;
    return std::nullopt;
}

/// Marks what lies inside: a path from outside crosses the outline an odd number of times. False
/// when an edge of the outline passes through a corner, so that it is no longer one.
bool mark_inside(Delaunay& triangulation,
                 const std::map<std::pair<Delaunay::Vertex_handle, Delaunay::Vertex_handle>, int>&
                     times_on_outline) {
    constexpr int unseen = -1;
    for (const auto f : triangulation.all_face_handles()) f->info() = unseen;
    std::vector<Delaunay::Face_handle> stack{triangulation.infinite_face()};
    stack.back()->info() = 0;
    while (!stack.empty()) {
        const auto f = stack.back();
        stack.pop_back();
        for (int side = 0; side < 3; ++side) {
            const auto other = f->neighbor(side);
            if (other->info() != unseen) continue;
            int crossings = 0;
            if (f->is_constrained(side)) {
                const auto edge = times_on_outline.find(
                    std::minmax(f->vertex(Delaunay::cw(side)), f->vertex(Delaunay::ccw(side))));
                if (edge == times_on_outline.end()) return false;
                crossings = edge->second;
            }
            other->info() = (f->info() + crossings) % 2;
            stack.push_back(other);
        }
    }
    return true;
}

/// Nothing when the outline crosses itself or has no area.
std::vector<Triangle> delaunay_triangles(const Outline& outline, const std::vector<Vec3>& points) {
    const std::vector<Point2> flat = flattened(outline, points);
    std::vector<std::size_t> order(flat.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto position = CGAL::make_property_map(flat);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(position)>(position));
    Delaunay triangulation;
    std::vector<Delaunay::Vertex_handle> corner(flat.size());
    Delaunay::Face_handle near;
    for (const std::size_t k : order) {
        const std::size_t before = triangulation.number_of_vertices();
        corner[k] = triangulation.insert(flat[k], near);
        near = corner[k]->face();
        const bool is_new = triangulation.number_of_vertices() > before;
        // Corners one behind the other: not flat enough to be seen from here.
        if (!is_new && points[corner[k]->info()] != points[outline[k]]) return {};
        corner[k]->info() = outline[k];
    }
    if (triangulation.dimension() < 2) return {};
    std::map<std::pair<Delaunay::Vertex_handle, Delaunay::Vertex_handle>, int> times_on_outline;
    try {
        for (std::size_t k = 0; k < corner.size(); ++k) {
            const auto next = corner[(k + 1) % corner.size()];
            if (corner[k] == next) continue;
            triangulation.insert_constraint(corner[k], next);
            ++times_on_outline[std::minmax(corner[k], next)];
        }
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
        return {};
    }
    if (!mark_inside(triangulation, times_on_outline)) return {};
    std::vector<Triangle> triangles;
    for (const auto f : triangulation.finite_face_handles())
        if (f->info() == 1)
            triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    // The order of CGAL's faces follows from the order in which it flipped edges.
    for (Triangle& t : triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

class Cutter {
  public:
    explicit Cutter(std::vector<Vec3> points) { soup_.points = std::move(points); }

    void cut(std::span<const std::uint32_t> face) {
        if (face.size() == 3) {
            soup_.triangles.push_back({face[0], face[1], face[2]});
            return;
        }
        Outline outline = without_repetitions(face);
        if (outline.size() < 3) return;
        const bool is_turned = make_canonical(outline);
        const std::size_t first = soup_.triangles.size();
        if (outline.size() == 4) {
            cut_quad(outline);
        } else if (outline.size() == 3) {
            soup_.triangles.push_back({outline[0], outline[1], outline[2]});
        } else {
            const std::vector<Triangle> triangles = delaunay_triangles(outline, soup_.points);
            if (triangles.empty()) cut_from_first(outline);
            soup_.triangles.insert(soup_.triangles.end(), triangles.begin(), triangles.end());
        }
        if (!is_turned) return;
        for (std::size_t t = first; t < soup_.triangles.size(); ++t)
            std::swap(soup_.triangles[t][1], soup_.triangles[t][2]);
    }

    TriangleSoup soup(RepairReport& report) {
        report.add(repeated_);
        report.add(crossing_);
        return std::move(soup_);
    }

  private:
    /// Corners in the place of the one before are dropped.
    Outline without_repetitions(std::span<const std::uint32_t> face) {
        Outline outline;
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::uint32_t next = face[(k + 1) % face.size()];
            if (soup_.points[face[k]] != soup_.points[next]) outline.push_back(face[k]);
        }
        if (outline.size() < face.size()) note(repeated_, face);
        return outline;
    }

    /// The outline from its lowest corner on, towards the lower of the two beside it. Returns
    /// whether it was turned round.
    bool make_canonical(Outline& outline) const {
        const auto lower = [this](std::uint32_t a, std::uint32_t b) {
            return is_before(soup_.points[a], soup_.points[b]);
        };
        std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end(), lower),
                    outline.end());
        if (!lower(outline.back(), outline[1])) return false;
        std::reverse(outline.begin() + 1, outline.end());
        return true;
    }

    void cut_quad(const Outline& quad) {
        const auto from = diagonal(quad, soup_.points);
        if (!from) return cut_from_first(quad);
        const auto k = static_cast<std::size_t>(*from);
        soup_.triangles.push_back({quad[k], quad[k + 1], quad[k + 2]});
        soup_.triangles.push_back({quad[k], quad[k + 2], quad[(k + 3) % 4]});
    }

    /// What has no area will be found to have none.
    void cut_from_first(const Outline& outline) {
        const auto point = [&](std::size_t k) {
            const Vec3& p = soup_.points[outline[k]];
            return Kernel::Point_3(p.x(), p.y(), p.z());
        };
        bool has_area = false;
        for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
            soup_.triangles.push_back({outline[0], outline[k], outline[k + 1]});
            has_area |= !CGAL::collinear(point(0), point(k), point(k + 1));
        }
        if (has_area) note(crossing_, outline);
    }

    void note(Finding& finding, std::span<const std::uint32_t> face) {
        if (finding.count++ == 0) finding.place = soup_.points[face[0]];
    }

    TriangleSoup soup_;
    Finding repeated_{.what = "faces that name a corner twice", .treatment = "named once"};
    Finding crossing_{.what = "faces whose outline crosses itself",
                      .treatment = "cut from one corner"};
};

}  // namespace

TriangleSoup face_triangles(PolygonSoup faces, RepairReport& report) {
    Cutter cutter(std::move(faces.points));
    for (std::size_t f = 0; f < faces.face_count(); ++f) cutter.cut(faces.face(f));
    return cutter.soup(report);
}

}  // namespace dem::shapegen
