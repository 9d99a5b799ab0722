// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"

/// Where the force acts by `contact = centroid` [GC] Sec. 5.2, Algorithm 4: at the centroid of the
/// patch in which the bodies overlap, seen along the normal (docs/contact-convex.md, "The centroid
/// rule").
namespace dem::runtime {

/// `deepest`: the nearest points of the cores, with the overlap of the rounded bodies; the same
/// with its position moved sideways to the centroid is returned.
FeaturePoint patch_centroid(const PlacedCore& i, const PlacedCore& j, const FeaturePoint& deepest,
                            const NearCores& near, ConvexScratch& scratch);

/// The centroid of the common part of two convex polygons given by points in any order; points and
/// segments are polygons without area. False where they have nothing in common.
bool common_centroid(std::vector<Vec2>& a, std::vector<Vec2>& b, Vec2& centroid);

}  // namespace dem::runtime
