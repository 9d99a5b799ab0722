// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/certificate/sdf_error.hpp"

#include "common/math/elementary.hpp"
#include "common/shapes/sdf_quadtree.hpp"
#include "shapegen/revolution/profile_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::shapegen {

namespace {

constexpr int depths = 9;

/// Direction of the exact gradient at x; on the surface itself the normal.
Vec2 exact_direction(const Profile& profile, const Vec2& x, double signed_distance) {
    const ProfilePoint nearest = profile.nearest(x);
    if (nearest.distance < 1e-9 * profile.major_axis_length()) {
        return profile.outward_normal(nearest.segment, nearest.t);
    }
    return (x - nearest.point) / signed_distance;
}

void measure_near_surface(const Profile& profile, const SdfQuadtree& sdf, double interface_size,
                          SdfError& error) {
    const auto samples = sample_profile(profile, profile.major_axis_length() / 1000.0);
    double weights = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double weight = samples[i].arc_length - samples[i - 1].arc_length;
        if (weight <= 0.0) continue;
        const Vec2 normal = profile.outward_normal(samples[i].segment, samples[i].t);
        for (int k = 0; k < depths; ++k) {
            const double offset = interface_size * (2.0 * k / (depths - 1) - 1.0);
            const Vec2 x = samples[i].point + offset * normal;
            const double exact = profile.signed_distance(x);
            if (x[0] < 0.0 || std::abs(exact) > interface_size) continue;
            const SdfSample s = interpolate(sdf, x[0], x[1]);
            const double e = std::abs(s.distance - exact);
            const Vec2 g = exact_direction(profile, x, exact);
            const double angle =
                std::abs(math::atan2(g[0] * s.d_dz - g[1] * s.d_dr, g[0] * s.d_dr + g[1] * s.d_dz));
            weights += weight;
            error.mean += weight * e;
            error.rms += weight * e * e;
            error.max = std::max(error.max, e);
            error.angle_rms += weight * angle * angle;
            error.angle_max = std::max(error.angle_max, angle);
        }
    }
    error.mean /= weights;
    error.rms = std::sqrt(error.rms / weights);
    error.angle_rms = std::sqrt(error.angle_rms / weights);
    error.max_near_surface = error.max;
}

void measure_cell(const Profile& profile, const SdfQuadtree& sdf, const Vec2& lower, double size,
                  double interface_size, SdfError& error) {
    constexpr std::array<std::array<double, 2>, 5> places{
        {{0.5, 0.5}, {0.2, 0.2}, {0.8, 0.2}, {0.2, 0.8}, {0.8, 0.8}}};
    for (const auto& [a, b] : places) {
        const Vec2 x = lower + size * Vec2(a, b);
        if (x[0] < 0.0) continue;
        const double found = interpolate(sdf, x[0], x[1]).distance;
        if (found < -interface_size) continue;
        const double e = std::abs(found - profile.signed_distance(x));
        if (found > 0.0) error.max_outside = std::max(error.max_outside, e);
        if (found < interface_size) error.max_near_surface = std::max(error.max_near_surface, e);
    }
}

}  // namespace

SdfError sdf_error(const Profile& profile, const SdfQuadtree& sdf, double interface_size) {
    SdfError error;
    measure_near_surface(profile, sdf, interface_size, error);
    for (std::uint32_t k = 0; k < sdf.cells_z; ++k) {
        for (std::uint32_t i = 0; i < sdf.cells_r; ++i) {
            const std::uint32_t n = 1U << sdf.cells[k * sdf.cells_r + i].level;
            const double size = sdf.base_size / n;
            const Vec2 corner{sdf.origin_r + sdf.base_size * i, sdf.origin_z + sdf.base_size * k};
            for (std::uint32_t b = 0; b < n; ++b) {
                for (std::uint32_t a = 0; a < n; ++a) {
                    measure_cell(profile, sdf, corner + size * Vec2(a, b), size, interface_size,
                                 error);
                }
            }
        }
    }
    error.max_outside = std::max(error.max_outside, error.max_near_surface);
    return error;
}

}  // namespace dem::shapegen
