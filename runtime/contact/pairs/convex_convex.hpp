// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"
#include "common/shapes/sphere.hpp"
#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/cores/features.hpp"

namespace dem::runtime {

/// Two convex shapes, and a sphere with one (docs/contact-convex.md): GJK on their cores, then the
/// features near the nearest points as one contact.
PairContact collide(const ConvexShape& a, const ConvexShape& b, const CoreCall& call);
PairContact collide(const Sphere& a, const ConvexShape& b, const CoreCall& call);

}  // namespace dem::runtime
