// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/convergence.hpp"

#include <string>

namespace dem::shapegen {

/// An SVG plot on logarithmic axes: what is not covered, the RMS deviation and the largest error of
/// a moment, against the number of spheres.
std::string convergence_plot(const std::string& name, const std::vector<ConvergenceRow>& rows);

}  // namespace dem::shapegen
