// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "formats/template_header.hpp"
#include "formats/template_writer.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <vector>

#include <flatbuffers/flatbuffers.h>

/// Small, complete, valid templates for the tests of the formats.
namespace dem::sample {

/// A unit octahedron, subdivided once and put on the sphere of `radius`: 18 vertices.
inline DisplayMesh sphere_mesh(double radius) {
    std::vector<Vec3> v = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const std::array<std::uint32_t, 3> faces[] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& f : faces) {
        std::array<std::uint32_t, 3> mid{};
        for (std::size_t e = 0; e < 3; ++e) {
            const Vec3 p = (v[f[e]] + v[f[(e + 1) % 3]]).normalized();
            std::uint32_t k = 0;
            while (k < v.size() && (v[k] - p).norm() > 1e-9) ++k;
            if (k == v.size()) v.push_back(p);
            mid[e] = k;
        }
        triangles.push_back({f[0], mid[0], mid[2]});
        triangles.push_back({f[1], mid[1], mid[0]});
        triangles.push_back({f[2], mid[2], mid[1]});
        triangles.push_back(mid);
    }
    for (Vec3& p : v) p *= radius;
    return {std::move(v), std::move(triangles), 0.3 * radius};
}

inline ParticleTemplate sphere(double radius, std::string name = "ball") {
    ParticleTemplate t;
    t.name = std::move(name);
    t.mass_properties.volume = 4.0 / 3.0 * pi * cube(radius);
    t.mass_properties.principal_moments_per_density =
        Vec3::Constant(0.4 * t.mass_properties.volume * square(radius));
    t.bounding_radius = radius;
    t.mean_squared_surface_distance = square(radius);
    t.is_convex = true;
    t.certificate = {{"volume_error", 0.0}, {"nodes", 20.0}};
    t.shape = Sphere{radius};
    return t;
}

/// A sphere of radius 2 mm as a surface of revolution, `count` nodes.
inline ParticleTemplate sr_sphere(std::uint32_t count = 20) {
    const double radius = 2e-3;
    ParticleTemplate t = sphere(radius, "sr ball");
    t.mass_properties.center_of_mass = {1e-4, -2e-4, 3e-4};
    t.mass_properties.principal_axes = Quat(0.5, -0.5, 0.5, 0.5);
    t.display_mesh = sphere_mesh(radius);
    SrShape sr;
    sr.is_convex = true;
    sr.bottom_z = -radius;
    sr.top_z = radius;
    sr.max_radius = radius;
    sr.bounding_radius = radius;
    sr.equivalent_diameter = 2.0 * radius;
    sr.major_axis_length = 2.0 * radius;
    sr.support.pieces = std::vector<SupportPiece>{{0, 0, radius, radius}, {0, 0, radius, radius}};
    sr.support.piece_end = std::vector<double>{0.25, 1.0};
    sr.support.first_piece = std::vector<std::uint32_t>{0, 0, 0, 1, 1};

    sr.sdf.origin_r = -1e-4;
    sr.sdf.origin_z = -2.5e-3;
    sr.sdf.base_size = 1e-3;
    sr.sdf.cells_r = 3;
    sr.sdf.cells_z = 5;
    sr.sdf.margin = 4e-4;
    sr.sdf.lipschitz_slack = 1e-4;
    sr.sdf.surface_slack = 1e-5;
    sr.sdf.surface_band = 2e-4;
    std::vector<SdfCell> cells;
    std::vector<double> values;
    for (std::uint32_t k = 0; k < 5; ++k) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t level = (i + k) % 2;
            const std::uint32_t n = 1U << level;
            cells.push_back({static_cast<std::uint32_t>(values.size()), level});
            for (std::uint32_t b = 0; b <= n; ++b) {
                for (std::uint32_t a = 0; a <= n; ++a) {
                    const double r = sr.sdf.origin_r + 1e-3 * (i + double(a) / n);
                    const double z = sr.sdf.origin_z + 1e-3 * (k + double(b) / n);
                    values.push_back(std::sqrt(r * r + z * z) - radius);
                }
            }
        }
    }
    sr.sdf.cells = std::move(cells);
    sr.sdf.values = std::move(values);

    std::vector<CurvatureSample> curvature;
    for (int i = 0; i <= 4; ++i) {
        const double angle = pi * i / 4.0;
        curvature.push_back({i % 4 == 0 ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle),
                             radius * angle, 1.0 / radius});
    }
    sr.curvature = std::move(curvature);

    const std::uint32_t blocks = (count + 15) / 16;
    std::vector<SurfaceNodes::Node> nodes;
    std::vector<std::uint32_t> stencil;
    for (std::uint32_t i = 0; i < 16 * blocks; ++i) {
        const std::uint32_t k = std::min(i, count - 1);
        const double z = -1.0 + 2.0 * k / (count - 1.0);
        const double s = std::sqrt(1.0 - z * z);
        const double phi = 2.0 * pi * std::numbers::phi * k;
        nodes.push_back(
            {radius * s * std::cos(phi), radius * s * std::sin(phi), radius * z, 1.0 / radius});
    }
    for (std::uint32_t i = 0; i < 16 * count; ++i) stencil.push_back((i / 16 + 1 + i % 16) % count);
    sr.nodes.count = count;
    sr.nodes.nodes = std::move(nodes);
    sr.nodes.blocks = std::vector<SurfaceNodes::Ball>(blocks, {0, 0, 0, 1.01 * radius});
    sr.nodes.super_blocks =
        std::vector<SurfaceNodes::Ball>((blocks + 15) / 16, {0, 0, 0, 1.01 * radius});
    sr.nodes.stencil = std::move(stencil);
    t.shape = std::move(sr);
    return t;
}

/// Twelve balls on a ring, a clump.
inline ParticleTemplate ring() {
    std::vector<ClumpSphere> spheres;
    ParticleTemplate t = sphere(1.5e-3, "ring");
    for (int k = 0; k < 12; ++k) {
        const double angle = pi * k / 6.0;
        spheres.push_back({1e-3 * std::cos(angle), 1e-3 * std::sin(angle), 0.0, 5e-4,
                           t.mass_properties.volume / 12.0});
    }
    t.is_convex = false;
    t.shape = make_clump(std::move(spheres));
    return t;
}

/// A rounded tetrahedron.
inline ParticleTemplate tetrahedron() {
    const std::vector<Vec3> corners{
        {1e-3, 1e-3, 1e-3}, {1e-3, -1e-3, -1e-3}, {-1e-3, 1e-3, -1e-3}, {-1e-3, -1e-3, 1e-3}};
    const shapegen::ConvexSolid solid = test::rounded_hull(corners, 5e-5);
    ParticleTemplate t = sphere(1.5e-3, "tetrahedron");
    t.mass_properties = solid.mass_properties;
    t.bounding_radius = std::max(t.bounding_radius, solid.shape.bounding_radius);
    t.mean_squared_surface_distance = solid.mean_squared_surface_distance;
    t.shape = solid.shape;
    return t;
}

inline TemplateFile file() {
    return {"shapegen ball.profile -o ball.tpl",
            0x0123456789abcdefULL,
            "0.1.0",
            {sphere(1.5e-3), sr_sphere(), ring(), tetrahedron()}};
}

/// Bytes in memory aligned as in a map.
struct Bytes {
    std::shared_ptr<std::vector<double>> memory;
    std::span<std::byte> bytes;

    explicit Bytes(std::size_t size)
        : memory(std::make_shared<std::vector<double>>((size + 7) / 8)),
          bytes(std::as_writable_bytes(std::span(*memory)).first(size)) {}
};

/// A file with the right header for whatever payload.
inline Bytes sealed(std::span<const std::byte> payload) {
    Bytes file(template_header_size + payload.size());
    const auto header = template_header(payload);
    std::memcpy(file.bytes.data(), header.data(), header.size());
    if (!payload.empty()) {
        std::memcpy(file.bytes.data() + header.size(), payload.data(), payload.size());
    }
    return file;
}

/// A file whose values nobody has checked.
inline Bytes unchecked(const TemplateFile& content) {
    const flatbuffers::DetachedBuffer payload = encode_template(content);
    return sealed(std::as_bytes(std::span(payload.data(), payload.size())));
}

}  // namespace dem::sample
