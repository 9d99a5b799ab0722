// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/surface_deviation.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

double surface_deviation(const Profile& profile, std::span<const Vec3> points,
                         std::span<const std::array<std::uint32_t, 3>> triangles) {
    double largest = 0.0;
    const auto measure = [&](const Vec3& x) {
        const Vec2 in_half_plane{math::hypot(x.x(), x.y()), x.z()};
        largest = std::max(largest, std::abs(profile.signed_distance(in_half_plane)));
    };
    for (const auto& [a, b, c] : triangles) {
        measure((points[a] + points[b] + points[c]) / 3.0);
        // Each edge belongs to two triangles that run along it in opposite ways: once is enough.
        if (a < b) measure(0.5 * (points[a] + points[b]));
        if (b < c) measure(0.5 * (points[b] + points[c]));
        if (c < a) measure(0.5 * (points[c] + points[a]));
    }
    return largest;
}

}  // namespace dem::shapegen
