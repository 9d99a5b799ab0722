// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/law/sphere_force.hpp"

namespace dem::runtime {

/// Where two spheres touch: in the middle of the overlap. `d`: from the center of i to that of j
/// [m]; `distance2`: its squared length.
template <class Real>
SpherePointOf<Real> touching_spheres(const Real& radius_i, const Real& radius_j,
                                     const Vec3Of<Real>& d, const Real& distance2) {
    using Vector = Vec3Of<Real>;
    const Real reach = radius_i + radius_j;
    const Real distance = root(distance2);
    // Coincident centers have no normal: any will do, the overlap check stops such a run.
    const Vector n = select(distance > 0.0, Vector(-d / distance), Vector(Vector::UnitZ()));
    const Real overlap = reach - distance;
    const Vector r_i = Real(-(radius_i - 0.5 * overlap)) * n;
    return {n, overlap, r_i, radius_i * radius_j / reach};
}

/// Two spheres.
inline PairContact collide(const Sphere& a, const Sphere& b, const SphereCall& call) {
    const Vec3& d = call.pair.displacement;
    const double distance2 = d.squaredNorm();
    if (!(distance2 < square(a.radius + b.radius))) return apart(call);
    return sphere_force<Partner::sphere>(touching_spheres(a.radius, b.radius, d, distance2),
                                         call.pair, call.law, call.dt, call.memory.history);
}

}  // namespace dem::runtime
