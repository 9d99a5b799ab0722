// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <cstdint>
#include <string>

namespace dem::runtime {

/// The critical times of a scene, [SR] Eq. 23 with the correction of docs/time-loop.md, and the
/// time step that follows.
struct TimeStep {
    double rayleigh = 0.0;  ///< T_R of the smallest body, less for stiff tangential springs [s]
    double hertz = 0.0;     ///< T_H, the shortest contact at the largest speed, likewise [s]
    /// 0.4 of the shortest contact of `model = linear`, so that the usual twentieth of it is t_c/50
    /// [s]; off the centers contacts are half as long, and steps above 2/pi of them diverge. Less
    /// where the restitution is below a half: strong dashpots diverge earlier.
    double linear = 0.0;
    /// In which the fastest body or wall travels the radius of the smallest body, or a wall
    /// oscillates half a period [s].
    double motion = 0.0;
    double largest_speed = 0.0;  ///< that was assumed [m/s]
    double critical = 0.0;       ///< the smallest of the times [s]
    double value = 0.0;          ///< given, or critical / RunSettings::time_step_divisor [s]
};

/// Throws Error when the given time step is above the critical one and not forced, or when there is
/// neither a time step nor a body to derive it from, or what follows is no time within the run.
TimeStep time_step(const Scene& scene);

/// Steps of `dt` [s] to the end time; the last one reaches it but for rounding. Throws Error(where,
/// ...) for more than can be counted.
std::uint64_t step_count(const RunSettings& run, double dt, const std::string& where);

}  // namespace dem::runtime
