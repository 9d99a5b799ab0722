// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

namespace dem::runtime {

/// How many contacts and bodies are computed at a time (docs/lanes.md): what the environment
/// variable DEM_LANES says, or as many as this processor does best. Throws Error where DEM_LANES
/// says what this processor cannot do.
int lane_width();

/// RunSettings::lanes, or lane_width() where it says nothing.
int lane_width(const Scene& scene);

}  // namespace dem::runtime
