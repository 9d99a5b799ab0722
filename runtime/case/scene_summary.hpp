// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <optional>
#include <string>

namespace dem::runtime {

/// Checks what reading cannot: the time step against the critical one, and that every region holds
/// what goes in at once (by doing it). Throws Error. Returns the scene in a few lines for a person:
/// bodies, mass, walls, contact laws, time step and why, overlaps, steps, a rough estimate of the
/// time it will take. `resumed_at`: the time of the checkpoint from which the run goes on [s].
std::string check_scene(const Scene& scene, std::optional<double> resumed_at = std::nullopt);

}  // namespace dem::runtime
