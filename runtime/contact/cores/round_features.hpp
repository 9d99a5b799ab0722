// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"

namespace dem::runtime {

/// The flat end of a cylinder or a cone.
struct PlacedCap {
    Vec3 center;      ///< [m]
    Vec3 axis;        ///< unit, out of the body
    double radius;    ///< [m]
    double size;      ///< [m]
    double rounding;  ///< [m]
    Vec3 across;      ///< unit, normal to the axis, fixed to the body

    CorePoint support(const Vec3& direction, std::uint32_t /*start*/) const {
        Vec3 sideways = direction - direction.dot(axis) * axis;
        const double length = sideways.norm();
        // Along the axis to rounding: all points of the disc are as far.
        if (length <= 1e-12 * direction.norm()) return {center};
        // What rounding has left along the axis would lift the point out of the disc.
        sideways -= sideways.dot(axis) * axis;
        return {center + (radius / length) * sideways};
    }

    /// Points fixed on the rim, evenly spread.
    static constexpr std::size_t sample_count = 16;
    Vec3 sample(std::size_t k) const;
    static Vec2 sample_direction(std::size_t k);
};

/// The flat ends of a core, none to two.
struct PlacedCaps {
    std::array<PlacedCap, 2> cap;
    std::size_t count = 0;
};
PlacedCaps caps_of(const PlacedCore& core);

/// How much each sample on a rim counts beside the rim's deepest point: a flat contact has several
/// times what makes the point superfluous, one or two samples beside it leave it alone.
inline constexpr double rim_sample_weight = 0.25;

/// Features of two bodies with flat or straight parts, at least one of which is a cylinder or a
/// cone: vertices, tip, the rim of every near end by its deepest point and by samples where it
/// lies flat, the straight side against edges. `deepest`: the nearest points of the cores. What
/// cannot touch while the leash in the memory lasts is left out; without a leash that is found,
/// and changes nothing.
void add_round(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
               const FeaturePoint& deepest, const CoreCall& call, FeatureSum& features);

}  // namespace dem::runtime
