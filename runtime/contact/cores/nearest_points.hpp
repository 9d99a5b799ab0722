// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/epa.hpp"
#include "runtime/contact/cores/gjk.hpp"
#include "runtime/contact/cores/placed_core.hpp"

namespace dem::runtime {

/// The nearest points of two cores that are apart, sharpened: where a core is curved GJK knows the
/// distance to rounding but its direction to the square root of that only. Projections from core
/// to core, which hardly get along by themselves where the gap is small, are extrapolated as a
/// linear map (Anderson 1965).
void sharpen(const PlacedCore& i, const PlacedCore& j, CoreDistance& found);

/// Sharpens the nearest points of cores that overlap, one of them an ellipsoid: i is moved out
/// until a gap is left, and the direction of the gap taken over as long as the overlap along it is
/// less.
void sharpen(const PlacedCore& i, const PlacedCore& j, Penetration& deepest);

}  // namespace dem::runtime
