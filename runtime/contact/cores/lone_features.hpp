// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"

namespace dem::runtime {

/// Most contacts of grains are one vertex on a face or one edge across another, far from all other
/// features. Where what can touch of the bodies (docs/contact-convex.md, "Features") proves that to
/// be so, adds the feature and returns true: to the bit what add_polyhedra() adds. Cores that do
/// not overlap. `lone`, `leash`: the feature, if it stays alone for a while, and for which.
bool add_lone_feature(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                      FeatureSum& features, LoneFeature& lone, Leash& leash);

/// The proof for a pair of which only one feature overlaps, by looking at all others; costs as
/// much as add_polyhedra() and is left out for some steps after it has failed.
void look_for_lone_feature(const PlacedCore& i, const PlacedCore& j, const PairState& pair,
                           const NearCores& near, ConvexScratch& scratch, LoneFeature& lone,
                           Leash& leash);

/// The overlap of the feature that is known to be alone [m]; not positive when there is none or it
/// does not touch. `normal`: of the contact in the step before.
double lone_overlap(const PlacedCore& i, const PlacedCore& j, const LoneFeature& lone,
                    const Vec3& normal);

/// Adds it. `features`: a sum with this overlap as the deepest.
void add_known_feature(const PlacedCore& i, const PlacedCore& j, const LoneFeature& lone,
                       const Vec3& normal, FeatureSum& features);

}  // namespace dem::runtime
