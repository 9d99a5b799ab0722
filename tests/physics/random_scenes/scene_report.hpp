// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <cstdint>
#include <string>

/// What was seen of a random scene from its first step to its last.
namespace dem::test {

using namespace runtime;

struct SceneSteps {
    int count;       ///< of steps
    double divisor;  ///< critical time over time step
};

struct SceneReport {
    double residual = 0.0;  ///< largest, of the ledger, over the energy that there is to lose
    double event = 0.0;     ///< largest change of that within 20 steps
    double moment = 0.0;    ///< of the event [s]
    double fastest = 0.0;   ///< speed of the fastest body ever seen [m/s]
    double overlap = 0.0;   ///< largest relative one of all steps looked at
    double kinetic = 0.0;   ///< energy at the end over that there was to lose
    /// Speed of the fastest body at the end [m/s], but for what a spin about the vertical gives its
    /// center: on a single point nothing resists it.
    double moving = 0.0;
    bool touched = false;
    bool cores_met = false;  ///< what then happens is no potential (docs/contact-convex.md)
    bool crushed = false;    ///< ended before its time: an overlap beyond the limit
    std::size_t bodies = 0;  ///< at the end
};

/// Throws Error where a scene ends for another reason than a crushed body.
SceneReport report_of(Scene scene, const SceneSteps& steps);

}  // namespace dem::test
