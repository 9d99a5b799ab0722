// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/simulation.hpp"

namespace dem {

/// Decides when everything has come to rest: nothing is left to insert, and the kinetic energy of
/// every body has stayed below a millionth of m g d (of d: the diameter of the sphere of equal
/// volume; the speed of a fall through d/10^6) for the time sqrt(d/g) of the largest body. At the
/// top of its flight a body is that slow for less than a hundredth of this time. Without gravity
/// g d is the square of the largest speed so far.
class AtRest {
  public:
    explicit AtRest(const Scene& scene);

    /// Call after each step.
    void look(const Simulation& simulation);

    bool was_reached() const { return was_reached_; }

    /// What has been seen so far, for checkpoints.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("at_rest.largest_speed2", self.largest_speed2_);
        visit("at_rest.slow_since", self.slow_since_);
        visit("at_rest.next_look", self.next_look_);
        visit("at_rest.was_reached", self.was_reached_);
    }

  private:
    bool is_slow(const Simulation& simulation);

    double largest_diameter_ = 0.0;  ///< [m]
    double gravity_;                 ///< [m/s^2]
    double largest_speed2_ = 0.0;    ///< [m^2/s^2]
    double slow_since_;              ///< [s]
    double next_look_ = 0.0;         ///< [s]
    bool was_reached_ = false;
};

}  // namespace dem
