// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/narrow_phase/bodies.hpp"

#include <optional>
#include <string>
#include <vector>

namespace dem::runtime {

/// Decides when everything has come to rest: nothing is left to insert, every wall that is to move
/// has begun and reached its speed, and every body
/// - is slow: its kinetic energy has stayed below a millionth of m g d (of d: the diameter of the
///   sphere of equal volume; the speed of a fall through d/10^6) for the time sqrt(d/g) of the
///   largest body. At the top of its flight a body is that slow for less than a hundredth of this
///   time. Without gravity g d is the square of the largest speed so far.
/// - or, in gravity, rocks in place, which no friction of the law damps: its center has stayed
///   within half of d, and its energy below a tenth of m g d, for a hundred times as long.
class AtRest {
  public:
    /// Walls that wait for the bodies to settle are to move, too, or (`of_settling`) are what this
    /// is asked for.
    explicit AtRest(const Scene& scene, bool of_settling = false);

    /// Call after each step. `time`: that of the bodies [s]; `is_inserted`: nothing is to come.
    void look(const Bodies& bodies, double time, bool is_inserted);

    bool was_reached() const { return was_reached_; }
    /// When it was: bodies that rock in place are among them.
    bool has_rocking() const { return has_rocking_; }

    /// What has been seen so far, for checkpoints.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit, const std::string& name = "at_rest") {
        visit(name + ".largest_speed2", self.largest_speed2_);
        visit(name + ".slow_since", self.slow_since_);
        visit(name + ".next_look", self.next_look_);
        visit(name + ".places", self.places_);
        visit(name + ".in_place_since", self.in_place_since_);
        visit(name + ".was_reached", self.was_reached_);
        visit(name + ".has_rocking", self.has_rocking_);
    }

  private:
    void look_at_energies(const Bodies& bodies);
    bool are_below(double energy, const Bodies& bodies) const;
    bool are_in_place(const Bodies& bodies) const;

    std::vector<double> speed2_;           ///< twice the kinetic energy over the mass [m^2/s^2]
    double largest_diameter_ = 0.0;        ///< [m]
    double motions_begin_ = 0.0;           ///< when the last wall has begun to move [s] ...
    std::optional<double> begin_settled_;  ///< ... and so long after the bodies settled [s]
    double gravity_;                       ///< [m/s^2]
    double largest_speed2_ = 0.0;          ///< [m^2/s^2]
    double slow_since_;                    ///< [s]
    std::vector<Vec3> places_;             ///< of the centers at the time `in_place_since_`
    double in_place_since_;                ///< [s]
    double next_look_ = 0.0;               ///< [s]
    bool was_reached_ = false;
    bool has_rocking_ = false;
};

}  // namespace dem::runtime
