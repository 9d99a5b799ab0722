// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/shell_nesting.hpp"

#include "shapegen/surface/surface_query.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem::shapegen {
namespace {

/// The lowest vertex connected with each vertex.
std::vector<std::uint32_t> connected_roots(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&root](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const auto& [i, j, k] : mesh.triangles)
        for (const std::uint32_t other : {j, k}) {
            const std::uint32_t a = find(i);
            const std::uint32_t b = find(other);
            root[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = find(v);
    return root;
}

}  // namespace

void Shell::turn() {
    for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
    volume = -volume;
}

Shells split_shells(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> root = connected_roots(mesh);
    std::vector<std::size_t> shell_of(mesh.vertices.size(), Shell::none);
    std::vector<std::uint32_t> position(mesh.vertices.size());
    std::vector<Shell> shells;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (shell_of[root[v]] == Shell::none) {
            shell_of[root[v]] = shells.size();
            shells.emplace_back();
        }
        shell_of[v] = shell_of[root[v]];
        TriangleMesh& surface = shells[shell_of[v]].surface;
        position[v] = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.push_back(mesh.vertices[v]);
    }
    std::vector<std::size_t> of_triangle;
    for (const auto& [i, j, k] : mesh.triangles) {
        of_triangle.push_back(shell_of[i]);
        shells[shell_of[i]].surface.triangles.push_back({position[i], position[j], position[k]});
    }
    for (Shell& shell : shells) {
        shell.volume = enclosed_volume(shell.surface);
        shell.box = bounding_box(shell.surface);
    }
    std::vector<std::size_t> order(shells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&shells](std::size_t a, std::size_t b) {
        return std::abs(shells[a].volume) > std::abs(shells[b].volume);
    });
    Shells result;
    std::vector<std::size_t> rank(shells.size());
    for (const std::size_t s : order) {
        rank[s] = result.list.size();
        result.list.push_back(std::move(shells[s]));
    }
    for (std::size_t& shell : of_triangle) shell = rank[shell];
    result.of_triangle = std::move(of_triangle);
    return result;
}

void nest(std::vector<Shell>& shells, const ShellPairs& crossing) {
    for (std::size_t outer = 0; outer < shells.size(); ++outer) {
        std::vector<std::size_t> candidates;
        for (std::size_t inner = outer + 1; inner < shells.size(); ++inner)
            if (shells[outer].box.contains(shells[inner].box.lower) &&
                shells[outer].box.contains(shells[inner].box.upper) &&
                !crossing.contains({outer, inner}))
                candidates.push_back(inner);
        if (candidates.empty()) continue;
        Shell outward = shells[outer];
        if (outward.is_turned()) outward.turn();
        const SurfaceQuery query(std::move(outward.surface));
        for (const std::size_t inner : candidates) {
            const auto& points = shells[inner].surface.vertices;
            const auto decisive = std::find_if(points.begin(), points.end(), [&](const Vec3& p) {
                return query.distance(p) > 0.0;
            });
            if (decisive == points.end() || !query.is_inside(*decisive)) continue;
            ++shells[inner].depth;
            shells[inner].parent = outer;  // the last one to come is the smallest
        }
    }
}

}  // namespace dem::shapegen
