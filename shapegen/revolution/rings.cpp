// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/rings.hpp"

#include "common/math/elementary.hpp"

#include <cmath>
#include <limits>

namespace dem::shapegen {

namespace {

double azimuth(const Ring& ring, std::uint32_t i) {
    return ring.phase + 2.0 * pi * i / ring.count;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Walks around both rings at once, each time along the ring whose next point comes first.
void zip(const Ring& lower, std::uint32_t first_lower, const Ring& upper, std::uint32_t first_upper,
         Triangles& triangles) {
    const std::uint32_t n = lower.count;
    const std::uint32_t m = upper.count;
    // The upper point at or after the first lower one, so that the walk starts on a short edge.
    const double turns = (lower.phase - upper.phase) / (2.0 * pi);
    const auto start = static_cast<std::int64_t>(std::ceil(turns * m - 1e-9));
    const double upper_origin = upper.phase + 2.0 * pi * static_cast<double>(start) / m;
    const auto shift = static_cast<std::uint32_t>(((start % m) + m) % m);
    constexpr double never = std::numeric_limits<double>::infinity();  // a pole has no next point
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    while (a < (n > 1 ? n : 0) || b < (m > 1 ? m : 0)) {
        const double next_a = n > 1 ? lower.phase + 2.0 * pi * (a + 1) / n : never;
        const double next_b = m > 1 ? upper_origin + 2.0 * pi * (b + 1) / m : never;
        const std::uint32_t at_a = first_lower + a % n;
        const std::uint32_t at_b = first_upper + (b + shift) % m;
        const bool along_lower = b >= m || (a < n && next_a <= next_b);
        if (along_lower) {
            triangles.push_back({at_a, first_lower + (a + 1) % n, at_b});
            ++a;
        } else {
            triangles.push_back({at_a, first_upper + (b + 1 + shift) % m, at_b});
            ++b;
        }
    }
}

}  // namespace

std::vector<Vec3> ring_points(std::span<const Ring> rings) {
    std::vector<Vec3> points;
    for (const Ring& ring : rings) {
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const double phi = azimuth(ring, i);
            points.emplace_back(ring.r * math::cos(phi), ring.r * math::sin(phi), ring.z);
        }
    }
    return points;
}

Triangles ring_triangles(std::span<const Ring> rings) {
    Triangles triangles;
    std::uint32_t first = 0;
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        const std::uint32_t next = first + rings[i].count;
        zip(rings[i], first, rings[i + 1], next, triangles);
        first = next;
    }
    return triangles;
}

void stagger(std::span<Ring> rings) {
    for (std::size_t i = 1; i < rings.size(); ++i) {
        rings[i].phase = std::fmod(rings[i - 1].phase + pi / rings[i].count, 2.0 * pi);
    }
}

}  // namespace dem::shapegen
