// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/simulation.hpp"

#include <string>
#include <utility>
#include <vector>

namespace dem::runtime {

/// Names of the columns that the measures of a scene fill, in the order of the case file:
/// NAME_highest, NAME_top_ten, NAME_surface for a fill height; NAME_coordination for contacts;
/// NAME_solid_fraction, NAME_near_wall, NAME_core for a solid fraction.
/// Throws Error for a solid fraction in a scene whose walls form no vessel.
std::vector<std::string> measure_columns(const Scene& scene);

/// The columns of one measure.
std::vector<std::string> measure_columns(const MeasureSettings& measure);

/// What they hold now.
std::vector<double> measure_values(const Simulation& simulation, const MeasureSettings& measure);

}  // namespace dem::runtime
