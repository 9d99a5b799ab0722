// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/unite_parts.hpp"

#include "shapegen/repair/self_intersections.hpp"
#include "shapegen/repair/shell_nesting.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

namespace dem::shapegen {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// What a shell is to the union.
enum class Role { part, hollow, held };

/// Turns the shells to what they are. They come by falling volume, so that the parent of a shell is
/// known before it. What lies in a part and faces like it is held by it, with all that it holds
/// itself, unless it reaches into a hollow of the part.
std::vector<Role> roles(std::vector<Shell>& shells, const ShellPairs& crossing) {
    std::vector<bool> is_opposite(shells.size(), false);  // to the shell around it
    for (std::size_t s = 0; s < shells.size(); ++s)
        is_opposite[s] = shells[s].parent != Shell::none &&
                         shells[s].is_turned() != shells[shells[s].parent].is_turned();
    const auto reaches_hollow = [&](std::size_t s) {
        return std::any_of(crossing.begin(), crossing.end(), [&](const auto& pair) {
            const std::size_t other = pair.first == s ? pair.second : pair.first;
            return (pair.first == s || pair.second == s) && is_opposite[other] &&
                   shells[other].parent == shells[s].parent;
        });
    };
    std::vector<Role> role(shells.size(), Role::part);
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (shells[s].parent == Shell::none) continue;
        const Role outer = role[shells[s].parent];
        if (outer == Role::held || (!is_opposite[s] && !reaches_hollow(s))) {
            role[s] = Role::held;
        } else if (is_opposite[s] && outer == Role::part) {
            role[s] = Role::hollow;
        }
    }
    for (std::size_t s = 0; s < shells.size(); ++s)
        if (shells[s].is_turned() != (role[s] == Role::hollow)) shells[s].turn();
    return role;
}

void append(ExactMesh& mesh, const TriangleMesh& surface) {
    std::vector<ExactMesh::Vertex_index> vertex;
    for (const Vec3& p : surface.vertices) vertex.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
    for (const auto& [i, j, k] : surface.triangles) mesh.add_face(vertex[i], vertex[j], vertex[k]);
}

Vec3 rounded(const ExactKernel::Point_3& p) {
    const auto& exact = CGAL::exact(p);
    return {CGAL::to_double(exact.x()), CGAL::to_double(exact.y()), CGAL::to_double(exact.z())};
}

void append(TriangleMesh& mesh, const TriangleMesh& surface) {
    const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), surface.vertices.begin(), surface.vertices.end());
    for (const auto& [i, j, k] : surface.triangles)
        mesh.triangles.push_back({i + shift, j + shift, k + shift});
}

TriangleMesh rounded(ExactMesh& mesh) {
    mesh.collect_garbage();
    TriangleMesh result;
    for (const auto v : mesh.vertices()) result.vertices.push_back(rounded(mesh.point(v)));
    for (const auto f : mesh.faces()) {
        const auto h = mesh.halfedge(f);
        result.triangles.push_back(
            {static_cast<std::uint32_t>(mesh.target(h).idx()),
             static_cast<std::uint32_t>(mesh.target(mesh.next(h)).idx()),
             static_cast<std::uint32_t>(mesh.target(mesh.next(mesh.next(h))).idx())});
    }
    return result;
}

SurfaceMesh surface_mesh(const TriangleMesh& mesh) {
    std::vector<Kernel::Point_3> points;
    for (const Vec3& p : mesh.vertices) points.emplace_back(p.x(), p.y(), p.z());
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const auto& [i, j, k] : mesh.triangles) triangles.push_back({i, j, k});
    SurfaceMesh surface;
    pmp::polygon_soup_to_polygon_mesh(points, triangles, surface);
    return surface;
}

/// Parts with their hollows, those together that cross in some of their shells.
std::vector<std::vector<std::size_t>> clusters(const std::vector<Shell>& shells,
                                               const std::vector<Role>& role,
                                               const ShellPairs& crossing) {
    std::vector<std::size_t> cluster(shells.size());
    for (std::size_t s = 0; s < shells.size(); ++s) cluster[s] = s;
    const auto find = [&cluster](std::size_t s) {
        while (cluster[s] != s) s = cluster[s] = cluster[cluster[s]];
        return s;
    };
    const auto join = [&](std::size_t a, std::size_t b) {
        const std::size_t low = std::min(find(a), find(b));
        cluster[find(a)] = cluster[find(b)] = low;
    };
    for (std::size_t s = 0; s < shells.size(); ++s)
        if (role[s] == Role::hollow) join(s, shells[s].parent);
    for (const auto& [a, b] : crossing)
        if (role[a] != Role::held && role[b] != Role::held) join(a, b);
    std::vector<std::vector<std::size_t>> result(shells.size());
    for (std::size_t s = 0; s < shells.size(); ++s)
        if (role[s] != Role::held) result[find(s)].push_back(s);
    std::erase_if(result, [](const auto& members) { return members.empty(); });
    return result;
}

/// The parts of a cluster one after the other; false where they have no union that is a surface.
bool unite(const std::vector<Shell>& shells, const std::vector<Role>& role,
           const std::vector<std::size_t>& cluster, TriangleMesh& result) {
    ExactMesh all;
    bool is_first = true;
    for (const std::size_t s : cluster) {
        if (role[s] != Role::part) continue;
        ExactMesh part;
        append(part, shells[s].surface);
        for (const std::size_t h : cluster)
            if (role[h] == Role::hollow && shells[h].parent == s) append(part, shells[h].surface);
        if (is_first) {
            all = std::move(part);
            is_first = false;
        } else if (!pmp::corefine_and_compute_union(
                       all, part, all, CGAL::parameters::throw_on_self_intersection(true))) {
            return false;
        }
    }
    append(result, rounded(all));
    return true;
}

void report_union(std::size_t parts, const Vec3& place, double shared, RepairReport& report) {
    constexpr double rounding = 1e-12;
    std::array<char, 80> words{};
    std::snprintf(words.data(), words.size(), "joined, %.3g %% of their volume was drawn twice",
                  shared > rounding ? 100.0 * shared : 0.0);
    report.add({"parts that cross, touch or hold each other", parts, place, words.data()});
}

}  // namespace

std::vector<Finding> unite_parts(SurfaceMesh& mesh, RepairReport& report) {
    Shells shells = split_shells(triangle_mesh(mesh));
    if (shells.list.size() == 1) return {};
    const SelfIntersections found = self_intersections(mesh);
    if (found.within.count > 0) return {found.within};
    ShellPairs crossing;
    for (const auto& [first, second] : found.pairs)
        crossing.insert(std::minmax({shells.of_triangle[first], shells.of_triangle[second]}));
    nest(shells.list, crossing);
    const std::vector<Role> role = roles(shells.list, crossing);

    TriangleMesh united;
    std::size_t joined = 0;
    Vec3 place = Vec3::Zero();
    double volume_of_parts = 0.0;
    const auto note_joined = [&](const Shell& shell) {
        if (joined++ == 0) place = shell.surface.vertices.front();
    };
    for (std::size_t s = 0; s < role.size(); ++s) {
        volume_of_parts += shells.list[s].volume;
        if (role[s] == Role::held) note_joined(shells.list[s]);
    }
    for (const auto& cluster : clusters(shells.list, role, crossing)) {
        const auto parts = std::count_if(cluster.begin(), cluster.end(),
                                         [&](std::size_t s) { return role[s] == Role::part; });
        if (parts == 1) {
            for (const std::size_t s : cluster) append(united, shells.list[s].surface);
            continue;
        }
        bool is_surface = false;
        try {
            is_surface = unite(shells.list, role, cluster, united);
        } catch (const pmp::Corefinement::Self_intersection_exception&) {
            is_surface = false;
        }
        if (!is_surface)
            return {{"parts that meet in an edge or a corner alone", cluster.size(),
                     shells.list[cluster.front()].surface.vertices.front(),
                     "expected parts that share volume or a face, or keep apart"}};
        for (const std::size_t s : cluster)
            if (role[s] == Role::part) note_joined(shells.list[s]);
    }
    if (joined == 0) return {};
    const double shared = 1.0 - enclosed_volume(united) / volume_of_parts;
    report_union(joined, place, shared, report);
    mesh = surface_mesh(united);
    return {};
}

}  // namespace dem::shapegen
