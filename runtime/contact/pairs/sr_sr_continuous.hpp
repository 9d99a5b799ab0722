// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sphere.hpp"
#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/law/contact_law.hpp"

namespace dem::runtime {

/// Convex surfaces of revolution, and spheres against them, at the one point where they share a
/// normal: `contact = continuous` (docs/contact.md, "Common normal"). Shapes must be convex. The
/// contact point lies midway between the two surface points. While touching the search starts from
/// the last normal; the first touch from the line of centers, so that `miss` never changes a bit.
PairContact collide(const SrShape& a, const SrShape& b, const SmoothCall& call);

PairContact collide(const Sphere& a, const SrShape& b, const SmoothCall& call);

}  // namespace dem::runtime
