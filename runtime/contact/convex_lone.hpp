// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/convex_features.hpp"

namespace dem {

/// Most contacts of grains are one vertex on a face or one edge across another, far from all other
/// features. Where what can touch of the bodies (docs/contact-convex.md, "Features") proves that to
/// be so, adds the feature and returns true: to the bit what add_polyhedra() adds. Cores that do
/// not overlap.
bool add_lone_feature(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                      FeatureSum& features);

}  // namespace dem
