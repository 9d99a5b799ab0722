// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/law/sphere_force.hpp"

#include <cmath>

namespace dem::runtime {

/// Two spheres; the contact point lies in the middle of the overlap.
inline PairContact collide(const Sphere& a, const Sphere& b, const SphereCall& call) {
    const Vec3& d = call.pair.displacement;
    const double reach = a.radius + b.radius;
    const double distance2 = d.squaredNorm();
    if (!(distance2 < reach * reach)) return apart(call);
    const double distance = std::sqrt(distance2);
    // Coincident centers have no normal: any will do, the overlap check stops such a run.
    const Vec3 n = distance > 0.0 ? Vec3(-d / distance) : Vec3::UnitZ();
    const double overlap = reach - distance;
    const Vec3 r_i = -(a.radius - 0.5 * overlap) * n;
    const SpherePoint point{n, overlap, r_i, a.radius * b.radius / reach};
    return sphere_force<Partner::sphere>(point, call.pair, call.law, call.dt, call.memory.history);
}

}  // namespace dem::runtime
