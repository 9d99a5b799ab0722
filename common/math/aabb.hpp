// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <limits>

namespace dem {

/// Axis-aligned box [m]; empty (lower > upper) when default constructed.
struct Aabb {
    Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 upper = Vec3::Constant(-std::numeric_limits<double>::infinity());

    bool is_empty() const { return (lower.array() > upper.array()).any(); }
    void extend(const Vec3& p) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    void extend(const Aabb& other) {
        lower = lower.cwiseMin(other.lower);
        upper = upper.cwiseMax(other.upper);
    }
    bool contains(const Vec3& p) const {
        return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
    }
};

/// True when the boxes, each side of one of them moved out by `margin` [m], touch.
inline bool overlaps(const Aabb& a, const Aabb& b, double margin = 0.0) {
    return (a.lower.array() <= b.upper.array() + margin).all() &&
           (b.lower.array() <= a.upper.array() + margin).all();
}

}  // namespace dem
