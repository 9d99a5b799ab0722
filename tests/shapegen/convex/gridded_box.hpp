// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <vector>

namespace dem::test {

/// As binary STL holds it.
inline Vec3 single_precision(const Vec3& p) {
    return p.cast<float>().cast<double>();
}

/// Corners of a box whose faces are grids, turned, in single precision. Rounding leaves the points
/// of a face 6e-8 of the extent beside its plane.
inline std::vector<Vec3> gridded_box(const Vec3& edges, int cells, const Quat& attitude) {
    std::vector<Vec3> points;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i <= cells; ++i) {
            for (int j = 0; j <= cells; ++j) {
                Vec3 p = Vec3::Constant(face < 3 ? 0.0 : 1.0);
                p[(face + 1) % 3] = static_cast<double>(i) / cells;
                p[(face + 2) % 3] = static_cast<double>(j) / cells;
                points.push_back(single_precision(attitude * p.cwiseProduct(edges)));
            }
        }
    }
    return points;
}

}  // namespace dem::test
