// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/fill_height.hpp"

#include "runtime/contact/pairs/touch.hpp"
#include "runtime/measure/height_map.hpp"
#include "runtime/measure/solid_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace dem::runtime {

namespace {

Vessel vessel_or_extent(const Particles& particles, const Scene& scene) {
    if (const auto vessel = find_vessel(scene)) return *vessel;
    Vessel vessel;
    vessel.up = up_direction(scene);
    for (const Vec3& x : particles.position) vessel.center += x;
    vessel.center /= static_cast<double>(particles.size());
    for (const Vec3& x : particles.position) {
        vessel.radius = std::max(vessel.radius, (x - vessel.center).cross(vessel.up).norm());
    }
    return vessel;
}

// Fine against one particle; a bed thousands of diameters wide does with coarser.
double spacing_of_lines(double diameter, double radius) {
    return std::max(0.05 * diameter, 1e-3 * radius);
}

double surface_height(const Particles& particles, const Scene& scene, const Vessel& vessel) {
    const Vec3 east = vessel.up.unitOrthogonal();
    const Vec3 north = vessel.up.cross(east);
    const double diameter = mean_diameter(particles, scene);
    const double radius = std::max(vessel.radius, 0.5 * diameter);
    HeightMap map(radius, spacing_of_lines(diameter, radius));
    const auto from_above = [&](const Vec3& x) -> Vec3 {
        const Vec3 d = x - vessel.center;
        return {d.dot(east), d.dot(north), x.dot(vessel.up) - vessel.floor};
    };
    std::vector<Vec3> vertices;
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[particles.kind[i]].shape];
        const Vec3& x = particles.position[i];
        if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) {
            map.add_sphere(from_above(x), sphere->radius);
            continue;
        }
        vertices.clear();
        for (const Vec3& vertex : shape.display_mesh.vertices) {
            vertices.push_back(from_above(x + particles.orientation[i] * vertex));
        }
        for (const auto& [a, b, c] : shape.display_mesh.triangles) {
            map.add_triangle(vertices[a], vertices[b], vertices[c]);
        }
    }
    return map.volume() / (vessel.shape == Vessel::Shape::box ? vessel.cross_section : map.area());
}

}  // namespace

FillHeight fill_height(const Particles& particles, const Scene& scene) {
    FillHeight result;
    if (particles.size() == 0) return result;
    const Vessel vessel = vessel_or_extent(particles, scene);

    std::vector<double> tops;
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[particles.kind[i]].shape];
        tops.push_back(particles.position[i].dot(vessel.up) +
                       extent(shape, particles.orientation[i], vessel.up) - vessel.floor);
    }
    const std::size_t ten = std::min<std::size_t>(10, tops.size());
    std::partial_sort(tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(ten), tops.end(),
                      std::greater<>());
    result.highest = tops.front();
    for (std::size_t k = 0; k < ten; ++k) result.top_ten += tops[k] / static_cast<double>(ten);
    result.surface = surface_height(particles, scene, vessel);
    return result;
}

}  // namespace dem::runtime
