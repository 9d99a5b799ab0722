// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"

/// Questions about resting geometry, answered by the same kernels that compute forces. For
/// insertion and measures; not for the time loop.
namespace dem::runtime {

/// Whether the two bodies overlap. Only displacement and orientations of `pair` are used.
bool touches(const ParticleTemplate& a, const ParticleTemplate& b, const PairState& pair);
bool touches(const ParticleTemplate& a, const WallShape& wall, const PairState& pair);

/// Signed extent of a shape along a unit direction given in the world frame: max over the body of
/// direction . (x - center of mass) [m]. Exact for spheres, clumps, convex and convex SR shapes,
/// for others the largest over their nodes.
double extent(const ParticleTemplate& shape, const Quat& orientation, const Vec3& direction);

}  // namespace dem::runtime
