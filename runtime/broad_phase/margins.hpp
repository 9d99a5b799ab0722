// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <span>
#include <vector>

namespace dem::runtime {

/// How far each particle may move before neighbor lists are made anew [m]. A given skin is shared
/// by the two bodies of a pair: half of it each. Otherwise every particle gets what it needs for
/// about `rebuild_interval` steps at its present speed, and a little of its size so that a resting
/// one can be hit: fast ones move far without making everyone's list long.
/// `surface_reach`, per kind: how far surface points lie from what they turn about [m].
std::vector<double> margins(const Particles& particles, const Scene& scene,
                            std::span<const double> surface_reach, double dt);

/// How far every wall may move before the lists are made again; 0 for walls that stand still.
std::vector<double> wall_margins(const Scene& scene);

}  // namespace dem::runtime
