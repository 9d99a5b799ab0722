// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/rival_normal.hpp"

#include "runtime/contact/smooth/normal_starts.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// Distance of a support point from the axis of its body [m].
double radius_of(const SupportSample& s, const Vec3& n, const Vec3& axis) {
    return s.point(n).cross(axis).norm();
}

}  // namespace

bool is_least_by_crossing(const NormalProbe& p, const SrSupport& i, const SrSupport& j,
                          const Vec3& d) {
    const double distance = d.norm();
    const double inner = i.map.bounds.inner_radius + j.map.bounds.inner_radius;
    // Minima as low as p.f lie within an angle from d whose cosine is `nearest`; p.n itself does.
    const double nearest = (inner - p.f) / distance;
    if (nearest >= 1.0) return true;
    if (!(nearest > -1.0)) return false;
    const double here = std::min(1.0, p.n.dot(d) / distance);
    const double farthest =
        here * nearest - std::sqrt(std::max(0.0, (1.0 - square(here)) * (1.0 - square(nearest))));
    const double r_i = radius_of(p.i, p.n, i.axis);
    const double r_j = radius_of(p.j, -p.n, j.axis);
    const double sine2 = 1.0 - square(p.i.meridian.dot(p.j.meridian));
    const double sum = r_i + r_j;
    const double least =
        0.5 * (sum - std::sqrt(std::max(0.0, square(sum) - 4.0 * r_i * r_j * sine2)));
    return least * (1.0 + farthest) >= 2.0 * p.f;
}

std::optional<NormalProbe> rival_normal(const NormalProbe& p, const SrSupport& i,
                                        const SrSupport& j, const Vec3& d, double highest) {
    constexpr double same_place = 1e-4;  // [rad]
    NormalStarts starts(4.0 * p.f);
    starts.add_meridian(i, p.n, 1.0);
    starts.add_meridian(j, -p.n, -1.0);
    if (radius_of(p.i, p.n, i.axis) < 4.0 * p.f) starts.add_tip(i, p.n, 1.0, j.axis);
    if (radius_of(p.j, -p.n, j.axis) < 4.0 * p.f) starts.add_tip(j, -p.n, -1.0, i.axis);
    std::optional<NormalProbe> lowest;
    for (const Vec3& start : starts) {
        const NormalProbe found = common_normal(i, j, d, start);
        if (found.f > highest || (lowest && found.f >= lowest->f)) continue;
        if ((found.n - p.n).squaredNorm() < square(same_place)) continue;
        lowest = found;
    }
    return lowest;
}

}  // namespace dem::runtime
