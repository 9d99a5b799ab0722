// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/types.hpp"

namespace dem {

/// Rotation by `angle` [rad] about the unit vector `axis`, counter-clockwise seen from its tip.
/// (Eigen's AngleAxis calls the C library, whose bits depend on the processor.)
inline Quat rotation_about(const Vec3& axis, double angle) {
    const auto [sine, cosine] = math::sin_cos(0.5 * angle);
    return {cosine, sine * axis.x(), sine * axis.y(), sine * axis.z()};
}

}  // namespace dem
