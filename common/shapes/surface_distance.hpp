// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

/// Inside or outside, and the nearest surface point, for every kind of shape. Points are given in
/// the body frame. For measures; contacts have kernels of their own.
namespace dem {

/// Signed distance of x from the surface and the unit vector away from the nearest surface point
/// (towards it from inside). Exact to rounding for spheres, clumps and convex shapes. Of surfaces
/// of revolution with the error of the distance field near the surface, which the certificate
/// states, and within 6e-5 l farther away (tests/consistency). Where several surface points are
/// equally near, one of them.
SurfaceDistance surface_distance(const ParticleTemplate& shape, const Vec3& x);
SurfaceDistance surface_distance(const Sphere& sphere, const Vec3& x);
SurfaceDistance surface_distance(const SrShape& shape, const Vec3& x);

/// Distance from the union of the spheres; inside it the nearest surface point may be one where two
/// or three spheres meet. From inside in a time that grows with the spheres that come as near as
/// that.
SurfaceDistance surface_distance(const Clump& clump, const Vec3& x);

/// Surface points count as inside. Sooner answered than surface_distance().
bool is_inside(const ParticleTemplate& shape, const Vec3& x);

}  // namespace dem
