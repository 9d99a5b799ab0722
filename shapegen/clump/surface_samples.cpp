// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/surface_samples.hpp"

#include <cmath>

namespace dem::shapegen {
namespace {

/// Barycentric place number k, uniform over the triangle: the additive sequence of the plastic
/// number (Roberts 2018), folded from the square.
Vec2 place_in_triangle(std::size_t k) {
    constexpr double plastic = 1.32471795724474602596;
    const double n = static_cast<double>(k) + 0.5;
    double ignored = 0.0;
    Vec2 place(std::modf(n / plastic, &ignored), std::modf(n / square(plastic), &ignored));
    if (place.sum() > 1.0) place = Vec2::Ones() - place;
    return place;
}

}  // namespace

std::vector<SurfaceSample> surface_samples(const TriangleMesh& mesh, std::size_t count) {
    std::vector<SurfaceSample> samples;
    samples.reserve(count);
    const double share = surface_area(mesh) / static_cast<double>(count);
    double passed = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3& a = mesh.vertices[i];
        const Vec3 ab = mesh.vertices[j] - a;
        const Vec3 ac = mesh.vertices[k] - a;
        const Vec3 normal = ab.cross(ac);
        passed += 0.5 * normal.norm();
        while (samples.size() < count &&
               (static_cast<double>(samples.size()) + 0.5) * share < passed) {
            const Vec2 place = place_in_triangle(samples.size());
            samples.push_back({a + place[0] * ab + place[1] * ac, normal.normalized()});
        }
    }
    return samples;
}

}  // namespace dem::shapegen
