// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

/// Interpolated signed distance and its exact gradient with respect to (r, z) (not normalized).
struct SdfSample {
    double distance;  ///< [m], negative inside
    double d_dr, d_dz;
};

/// Bilinear look-up [SR] Eqs. 5-7 in constant time. A point x outside the grid is moved to the
/// nearest point c of the grid and gets sqrt(phi(c)^2 + |x - c|^2). The grid is convex and holds
/// the whole cross-section, so this never exceeds the true distance, it is continuous, and it keeps
/// the bound of SdfQuadtree::lipschitz_slack: a search may discard by it.
inline SdfSample interpolate(const SdfQuadtree& sdf, double r, double z) {
    const double per_length = 1.0 / sdf.base_size;  // one division, and none in a loop over points
    const double u = (r - sdf.origin_r) * per_length;
    const double v = (z - sdf.origin_z) * per_length;
    const double uc = std::clamp(u, 0.0, static_cast<double>(sdf.cells_r) * (1.0 - 1e-15));
    const double vc = std::clamp(v, 0.0, static_cast<double>(sdf.cells_z) * (1.0 - 1e-15));
    const auto i = static_cast<std::uint32_t>(uc);
    const auto k = static_cast<std::uint32_t>(vc);
    const SdfCell cell = sdf.cells[std::size_t{k} * sdf.cells_r + i];
    const std::uint32_t n = 1U << cell.level;
    const double x = (uc - i) * n;
    const double y = (vc - k) * n;
    const auto a = static_cast<std::uint32_t>(x);
    const auto b = static_cast<std::uint32_t>(y);
    const double* value = sdf.values.data() + cell.first_value + std::size_t{b} * (n + 1) + a;
    const double p = x - a;
    const double q = y - b;
    const double lower = value[0] + p * (value[1] - value[0]);
    const double upper = value[n + 1] + p * (value[n + 2] - value[n + 1]);
    const double scale = n * per_length;
    SdfSample s{lower + q * (upper - lower),
                ((1.0 - q) * (value[1] - value[0]) + q * (value[n + 2] - value[n + 1])) * scale,
                (upper - lower) * scale};
    if (u != uc || v != vc) {
        const double dr = (u - uc) * sdf.base_size;
        const double dz = (v - vc) * sdf.base_size;
        const double at_edge = s.distance;
        s.distance = std::sqrt(at_edge * at_edge + dr * dr + dz * dz);
        const double share = at_edge / s.distance;
        s.d_dr = u != uc ? dr / s.distance : s.d_dr * share;
        s.d_dz = v != vc ? dz / s.distance : s.d_dz * share;
    }
    return s;
}

}  // namespace dem
