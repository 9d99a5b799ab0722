// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/sphere_template.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace dem::runtime {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct UnitMesh {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

UnitMesh icosahedron() {
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    UnitMesh mesh;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-golden, golden}) {
            mesh.vertices.push_back(Vec3(a, b, 0.0).normalized());
            mesh.vertices.push_back(Vec3(0.0, a, b).normalized());
            mesh.vertices.push_back(Vec3(b, 0.0, a).normalized());
        }
    }
    // A face is three vertices at the edge length from each other, counter-clockwise from outside.
    const double edge = 2.0 / std::sqrt(1.0 + golden * golden);
    const auto adjacent = [&](std::uint32_t i, std::uint32_t k) {
        return (mesh.vertices[i] - mesh.vertices[k]).norm() < 1.01 * edge;
    };
    for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t j = i + 1; j < 12; ++j) {
            for (std::uint32_t k = j + 1; k < 12; ++k) {
                if (!adjacent(i, j) || !adjacent(j, k) || !adjacent(i, k)) continue;
                const auto& v = mesh.vertices;
                const bool is_outward = v[i].dot(v[j].cross(v[k])) > 0.0;
                mesh.triangles.push_back(is_outward ? Triangle{i, j, k} : Triangle{i, k, j});
            }
        }
    }
    return mesh;
}

/// Every triangle into four, the new vertices moved out to the unit sphere.
UnitMesh divided(const UnitMesh& coarse) {
    UnitMesh fine{coarse.vertices, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, is_new] =
            middle.emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.vertices.size()));
        if (is_new) {
            fine.vertices.push_back((coarse.vertices[a] + coarse.vertices[b]).normalized());
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const std::uint32_t ab = between(a, b);
        const std::uint32_t bc = between(b, c);
        const std::uint32_t ca = between(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
            fine.triangles.push_back(t);
        }
    }
    return fine;
}

DisplayMesh display_mesh(double radius) {
    UnitMesh mesh = divided(divided(icosahedron()));
    double nearest = 1.0;  // the middles of the faces are the deepest points
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 sum = mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c];
        nearest = std::min(nearest, sum.norm() / 3.0);
    }
    for (Vec3& v : mesh.vertices) v *= radius;
    return {std::move(mesh.vertices), std::move(mesh.triangles), radius * (1.0 - nearest)};
}

}  // namespace

ParticleTemplate sphere_template(double radius) {
    ParticleTemplate t;
    t.name = "sphere";
    t.mass_properties.volume = 4.0 / 3.0 * pi * cube(radius);
    t.mass_properties.principal_moments_per_density =
        Vec3::Constant(0.4 * t.mass_properties.volume * square(radius));
    t.bounding_radius = radius;
    t.mean_squared_surface_distance = square(radius);
    t.is_convex = true;
    t.display_mesh = display_mesh(radius);
    t.shape = Sphere{radius};
    return t;
}

}  // namespace dem::runtime
