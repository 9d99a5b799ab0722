// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "runtime/contact/law/sphere_force.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

namespace dem::runtime {

/// Whether a sphere touches a wall that is a field in the frame of its center; `here`: sample of
/// the field at the center; `radius`: of the sphere [m].
template <class Field, class Real>
MaskOf<Real> touches_wall(const Field& field, const typename Field::Sample& here,
                          const Real& radius) {
    const Vec3Of<Real> center = Vec3Of<Real>::Zero();
    return both(radius - here.distance > 0.0,
                both(field.accepts(center), no(field.lets_pass(center))));
}

/// Where it does.
template <class Field, class Real>
SpherePointOf<Real> sphere_at_wall(const Field& field, const typename Field::Sample& here,
                                   const Real& radius) {
    const Vec3Of<Real> normal = field.gradient(Vec3Of<Real>::Zero(), here);
    const Real overlap = radius - here.distance;
    return {normal, overlap, Real(-(radius - 0.5 * overlap)) * normal, radius};
}

/// A sphere against a wall (wall_shapes.hpp), which it touches in the point of the wall nearest to
/// its center. The wall's curvature does not enter R*.
template <AnyWall Wall>
PairContact collide(const Sphere& a, const Wall& wall, const SphereCall& call);

}  // namespace dem::runtime
