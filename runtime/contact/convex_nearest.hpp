// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/gjk.hpp"
#include "runtime/contact/placed_core.hpp"

namespace dem {

/// The nearest points of two cores that are apart, sharpened: where a core is curved GJK knows the
/// distance to rounding but its direction to the square root of that only. Projections from core
/// to core, which hardly get along by themselves where the gap is small, are extrapolated as a
/// linear map (Anderson 1965).
void sharpen(const PlacedCore& i, const PlacedCore& j, CoreDistance& found);

}  // namespace dem
