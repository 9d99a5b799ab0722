// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/placed_core.hpp"

#include <limits>

/// The distance of two polyhedra by all their features.
namespace dem::test {

using namespace runtime;

inline Vec3 direction_of(const PlacedCore& core, const ConvexShape::Edge& e) {
    return core.vertex(e.to) - core.vertex(e.from);
}

/// Along the unit normal from j towards i; negative where a vertex of one lies in the other.
inline SurfaceDistance polyhedron_gap(const PlacedCore& i, const PlacedCore& j) {
    SurfaceDistance least{std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
    const auto offer = [&](double distance, const Vec3& normal) {
        if (distance < least.distance) least = {distance, normal};
    };
    for (std::uint32_t v = 0; v < i.shape.vertices.size(); ++v) {
        const SurfaceDistance d = core_distance(j.shape, j.in_body(i.vertex(v)));
        offer(d.distance, j.turned(d.normal));
    }
    for (std::uint32_t v = 0; v < j.shape.vertices.size(); ++v) {
        const SurfaceDistance d = core_distance(i.shape, i.in_body(j.vertex(v)));
        offer(d.distance, -i.turned(d.normal));
    }
    for (const ConvexShape::Edge& e : i.shape.edges) {
        for (const ConvexShape::Edge& f : j.shape.edges) {
            const Vec3 u = direction_of(i, e);
            const Vec3 w = direction_of(j, f);
            const Vec3 across = u.cross(w);
            const double square_sine = across.squaredNorm();
            if (square_sine < 1e-12 * u.squaredNorm() * w.squaredNorm()) continue;
            const Vec3 r = j.vertex(f.from) - i.vertex(e.from);
            const double s = r.cross(w).dot(across) / square_sine;
            const double t = r.cross(u).dot(across) / square_sine;
            if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) continue;
            const Vec3 gap = s * u - t * w - r;
            offer(gap.norm(), gap.normalized());
        }
    }
    return least;
}

}  // namespace dem::test
