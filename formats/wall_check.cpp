// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_check.hpp"
#include "formats/value_check.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr double farthest_vertex = 1e6;  // [m], as everywhere

void check_wall_sizes(const WallMesh& mesh, const ValueCheck& check) {
    const std::size_t triangles = mesh.triangles.size();
    check.require(triangles > 0, "a wall has no triangles");
    check.require(triangles <= 0xffff'ffffU / 3, "a wall has more than 1.4e9 triangles");
    check.require(mesh.twins.size() == 3 * triangles && mesh.bends.size() == 3 * triangles &&
                      mesh.patches.size() == triangles,
                  "the edges or patches of a wall do not match its triangles in number");
    check.finite(mesh.crease_angle, "crease angle");
    check.require(mesh.crease_angle >= 0.0 && mesh.crease_angle < WallMesh::sharp,
                  "the crease angle of a wall is not from 0 to 180 degrees");
}

void check_wall_triangles(const WallMesh& mesh, const ValueCheck& check) {
    for (const Vec3& v : mesh.vertices) {
        check.finite(v, "vertex of a wall");
        check.require(v.cwiseAbs().maxCoeff() <= farthest_vertex,
                      "a vertex of a wall is farther than 1e6 m from the origin");
    }
    for (const WallMesh::Triangle& t : mesh.triangles) {
        check.require(std::max({t[0], t[1], t[2]}) < mesh.vertices.size(),
                      "a triangle of a wall names a vertex that does not exist");
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3 doubled = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        check.require(doubled.squaredNorm() > 0.0, "a triangle of a wall has no area");
    }
}

/// The ends of a half edge, the lower vertex first.
std::array<std::uint32_t, 2> ends(const WallMesh& mesh, std::uint32_t half_edge) {
    const WallMesh::Triangle& t = mesh.triangles[half_edge / 3];
    const auto [low, high] = std::minmax(t[half_edge % 3], t[(half_edge + 1) % 3]);
    return {low, high};
}

void check_wall_edges(const WallMesh& mesh, const ValueCheck& check) {
    std::vector<std::uint8_t> followed(mesh.twins.size(), 0);
    for (std::uint32_t h = 0; h < mesh.twins.size(); ++h) {
        const std::uint32_t twin = mesh.twins[h];
        check.require(twin < mesh.twins.size(), "an edge of a wall has a twin that does not exist");
        check.require(ends(mesh, twin) == ends(mesh, h) && followed[twin] == 0,
                      "the triangles around an edge of a wall do not share it");
        followed[twin] = 1;
        check.require(std::abs(mesh.bends[h]) <= WallMesh::sharp,
                      "an edge of a wall bends by more than 180 degrees");
    }
}

void check_wall_patches(const WallMesh& mesh, const ValueCheck& check) {
    for (const double blend : mesh.blends) check.not_negative(blend, "blending of a patch");
    for (const std::uint32_t patch : mesh.patches)
        check.require(patch < mesh.blends.size(), "a triangle of a wall has no patch");
}

/// Every box ends within the one around it, and the leaves hold all triangles in their order.
void check_wall_boxes(const WallMesh& mesh, const ValueCheck& check) {
    const auto count = static_cast<std::uint32_t>(mesh.boxes.size());
    std::uint32_t next_triangle = 0;
    std::vector<std::uint32_t> open;  // boxes around the present one
    for (std::uint32_t b = 0; b < count; ++b) {
        while (!open.empty() && mesh.boxes[open.back()].next == b) open.pop_back();
        const WallMesh::Box& box = mesh.boxes[b];
        const std::uint32_t end = open.empty() ? count : mesh.boxes[open.back()].next;
        check.require(box.next > b && box.next <= end && (box.count == 0 || box.next == b + 1),
                      "the boxes of a wall do not nest");
        check.require(box.first == next_triangle && box.count <= mesh.triangles.size() - box.first,
                      "the boxes of a wall do not hold its triangles in their order");
        next_triangle += box.count;
        open.push_back(b);
        for (std::uint32_t t = box.first; t < box.first + box.count; ++t) {
            for (const std::uint32_t corner : mesh.triangles[t]) {
                for (const std::uint32_t around : open) {
                    const WallMesh::Box& holder = mesh.boxes[around];
                    const Vec3& v = mesh.vertices[corner];
                    check.require((v.array() >= holder.lower.array()).all() &&
                                      (v.array() <= holder.upper.array()).all(),
                                  "a triangle of a wall lies outside of its box");
                }
            }
        }
    }
    check.require(next_triangle == mesh.triangles.size(),
                  "the boxes of a wall do not hold all of its triangles");
}

}  // namespace

void check_wall_mesh(const WallMesh& mesh, const std::string& where) {
    const ValueCheck check{where};
    check_wall_sizes(mesh, check);
    check_wall_triangles(mesh, check);
    check_wall_edges(mesh, check);
    check_wall_patches(mesh, check);
    check_wall_boxes(mesh, check);
}

}  // namespace dem
