// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

namespace dem::runtime {

/// What the rest of a run probably costs on one core of 2.6 to 3 GHz [s]; good enough to tell
/// minutes from days.
struct RunCost {
    double steps = 0.0;     ///< shared by threads
    double measures = 0.0;  ///< by one
};

/// From a time of the run on, with time steps of `dt` [s].
RunCost run_cost(const Scene& scene, double from, double dt);

/// Time of the last batch of a group if none finds its region occupied [s]; the start for other
/// groups.
double last_insertion(const InsertionGroup& group);

}  // namespace dem::runtime
