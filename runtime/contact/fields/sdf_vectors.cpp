// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/fields/sdf_vectors.hpp"

#include "common/shapes/sdf_quadtree.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// Even in r, as the field is, where a difference reaches across the axis.
double distance(const SdfQuadtree& sdf, double r, double z) {
    return interpolate(sdf, std::abs(r), z).distance;
}

Vec2 grid_vector(const SdfQuadtree& sdf, double r, double z, double step) {
    const Vec2 gradient(distance(sdf, r + step, z) - distance(sdf, r - step, z),
                        distance(sdf, r, z + step) - distance(sdf, r, z - step));
    const double length = gradient.norm();
    return length > 0.0 ? Vec2(distance(sdf, r, z) / length * gradient) : Vec2::Zero();
}

}  // namespace

Vec2 interpolated_distance_vector(const SdfQuadtree& sdf, double r, double z) {
    const double u = (r - sdf.origin_r) / sdf.base_size;
    const double v = (z - sdf.origin_z) / sdf.base_size;
    const auto i = static_cast<std::uint32_t>(std::clamp(u, 0.0, sdf.cells_r - 1.0));
    const auto k = static_cast<std::uint32_t>(std::clamp(v, 0.0, sdf.cells_z - 1.0));
    const double n = static_cast<double>(1U << sdf.cells[k * sdf.cells_r + i].level);
    const double size = sdf.base_size / n;
    const double a = std::floor(u * n);
    const double b = std::floor(v * n);
    const double p = u * n - a;
    const double q = v * n - b;
    const double r0 = sdf.origin_r + a * size;
    const double z0 = sdf.origin_z + b * size;
    const Vec2 lower =
        (1.0 - p) * grid_vector(sdf, r0, z0, size) + p * grid_vector(sdf, r0 + size, z0, size);
    const Vec2 upper = (1.0 - p) * grid_vector(sdf, r0, z0 + size, size) +
                       p * grid_vector(sdf, r0 + size, z0 + size, size);
    return (1.0 - q) * lower + q * upper;
}

}  // namespace dem::runtime
