// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

/// Closed, outward meshes for tests.
namespace dem::sample {

using namespace shapegen;

/// The box from `lower` to `upper`, 12 triangles.
inline TriangleMesh box(const Vec3& lower, const Vec3& upper) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.emplace_back((k & 1) != 0 ? upper.x() : lower.x(),
                                   (k & 2) != 0 ? upper.y() : lower.y(),
                                   (k & 4) != 0 ? upper.z() : lower.z());
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// The tetrahedron (0, a, b, c), outward when a . (b x c) > 0.
inline TriangleMesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {{Vec3::Zero(), a, b, c}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
}

/// A unit octahedron whose triangles are split into four `levels` times, the vertices pushed out
/// to the sphere of the given radius: 8 * 4^levels triangles.
inline TriangleMesh sphere(double radius, int levels) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3::UnitX(),        Vec3(-Vec3::UnitX()), Vec3::UnitY(),
                     Vec3(-Vec3::UnitY()), Vec3::UnitZ(),        Vec3(-Vec3::UnitZ())};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_of;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto [entry, is_new] = middle_of.try_emplace(std::minmax(a, b), next);
            if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return entry->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Vec3& vertex : mesh.vertices) vertex *= radius;
    return mesh;
}

/// A torus about z: `n` x `m` quads, each split in two.
inline TriangleMesh torus(double ring_radius, double tube_radius, std::uint32_t n,
                          std::uint32_t m) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < m; ++j) {
            const double u = 2.0 * pi * i / n;
            const double v = 2.0 * pi * j / m;
            const double r = ring_radius + tube_radius * std::cos(v);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v));
            const std::uint32_t i1 = (i + 1) % n;
            const std::uint32_t j1 = (j + 1) % m;
            const std::array<std::uint32_t, 4> quad{i * m + j, i1 * m + j, i1 * m + j1, i * m + j1};
            mesh.triangles.push_back({quad[0], quad[1], quad[2]});
            mesh.triangles.push_back({quad[0], quad[2], quad[3]});
        }
    }
    return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Mat3& linear, const Vec3& shift) {
    for (Vec3& vertex : mesh.vertices) vertex = linear * vertex + shift;
    return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// Both surfaces in one mesh.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
    const auto shift = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles)
        a.triangles.push_back({i + shift, j + shift, k + shift});
    return a;
}

}  // namespace dem::sample
