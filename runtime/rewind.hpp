// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/checkpoint_file.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <memory>

namespace dem::runtime {

/// A way back from a step that failed to the last good state before it. Now and then, as often as
/// costs nothing, it keeps a state in memory; from there the steps are taken again, with the same
/// bits.
class Rewind {
  public:
    /// Keeps the present state. `now`: Progress::steady_seconds().
    Rewind(const Simulation& simulation, double now) { keep(simulation, now); }

    bool is_due(double now) const { return now >= next_; }
    void keep(const Simulation& simulation, double now);

    /// A simulation of the same scene after `steps` steps, no fewer than those of the state kept,
    /// or after the last of them that ended with finite numbers.
    std::unique_ptr<Simulation> back_to(std::uint64_t steps, const Simulation& failed) const;

  private:
    Checkpoint state_;
    double next_ = 0.0;  ///< when it is due again
};

}  // namespace dem::runtime
