// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/rival_normal.hpp"

#include "runtime/contact/smooth/normal_starts.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

std::optional<NormalProbe> rival_normal(const NormalProbe& p, const SrSupport& i,
                                        const SrSupport& j, const Vec3& d, double highest) {
    constexpr double same_place = 1e-4;  // [rad]
    NormalStarts starts(4.0 * p.f);
    starts.add_meridian(i, p.n, 1.0);
    starts.add_meridian(j, -p.n, -1.0);
    if (radius_of<double>(p.i, p.n, i.axis) < 4.0 * p.f) starts.add_tip(i, p.n, 1.0, j.axis);
    if (radius_of<double>(p.j, -p.n, j.axis) < 4.0 * p.f) starts.add_tip(j, -p.n, -1.0, i.axis);
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
