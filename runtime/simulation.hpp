// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/threads/step_team.hpp"
#include "runtime/broad_phase/body_aabb.hpp"
#include "runtime/insertion/inserter.hpp"
#include "runtime/integrator/integrator.hpp"
#include "runtime/measure/at_rest.hpp"
#include "runtime/narrow_phase/force_sum.hpp"
#include "runtime/narrow_phase/narrow_phase.hpp"
#include "runtime/narrow_phase/neighbor_lists.hpp"
#include "runtime/outlets/outlets.hpp"
#include "runtime/particles.hpp"
#include "runtime/scene.hpp"
#include "runtime/walls/moving_walls.hpp"
#include "runtime/walls/tunnels.hpp"
#include "runtime/walls/wall_loads.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace dem::runtime {

class StateReader;
class StateWriter;

/// The time loop of one scene. Its state after any number of steps has the same bits for any number
/// of threads (RunSettings::threads), which may change from step to step, and any skin.
class Simulation {
  public:
    /// Places the walls and inserts what is due at time 0. `dt`: time step [s].
    /// Throws Error when that cannot be inserted.
    Simulation(Scene scene, double dt);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// One time step (docs/time-loop.md). Throws Error with step, time and ids when a body has left
    /// the domain, has gone through a mesh wall, is nowhere (not a number) or overlaps by more than
    /// RunSettings::overlap_limit. The state is then that of the failed step. `looks`: whether it
    /// notes its contacts one by one where OutputSettings::contacts asks for them, which takes
    /// longer and changes no bit.
    void step(bool looks = false);

    double time() const { return static_cast<double>(steps_) * dt_; }  ///< [s]
    double time_step() const { return dt_; }                           ///< [s]
    std::uint64_t steps() const { return steps_; }

    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }
    const MovingWalls& walls() const { return walls_; }
    const NeighborLists& lists() const { return lists_; }
    bool has_waiting_motion() const { return motions_wait_ && std::isinf(walls_.settled); }
    const EnergyLedger& ledger() const { return ledger_; }
    const Inserter& inserter() const { return inserter_; }
    bool is_inserted() const { return std::isinf(inserter_.next_time()); }  ///< all that is to be
    const Outlets& outlets() const { return outlets_; }
    const LargestOverlap& largest_overlap() const { return largest_overlap_; }  ///< of this step
    /// Contacts in which the cores of two convex bodies have overlapped, so far.
    std::uint64_t core_overlaps() const { return core_overlaps_; }
    /// The contacts of this step between bodies that are still there, world frame, before the last
    /// correction of velocities; null unless the step looked. Those at time 0 are known, too.
    const std::vector<SeenContact>* contacts() const {
        return scratch_.looks == Looks::at_all ? &scratch_.seen : nullptr;
    }
    const WallLoads& wall_loads() const { return wall_loads_; }
    const StepTeam& team() const { return team_; }
    LaneUse lanes() const { return lane_use(scratch_); }         ///< of this step
    double inserted_energy() const { return inserted_energy_; }  ///< of all bodies when new [J]
    Bodies bodies() const { return {scene_, particles_, walls_}; }

    /// Over position, orientation, velocity and angular momentum of all bodies in the order of ids.
    std::uint64_t state_hash() const;

    // checkpoint/simulation_state.cpp
    void save(StateWriter& writer) const;
    /// For a simulation of the same scene fresh from its constructor: it goes on with the same bits
    /// as the one that was saved. Throws Error for a state that is not of this scene.
    void load(StateReader& reader);

  private:
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit);
    void insert_due();
    void let_out();
    void begin_motions();
    void rebuild_lists();
    void check_bodies() const;
    void check_tunnels() const;
    void check_overlap() const;
    std::string here() const;

    Scene scene_;
    StepTeam team_;
    double dt_;
    std::uint64_t steps_ = 0;
    Aabb domain_;
    BodyAabbs aabbs_;
    std::vector<double> surface_reach_;  ///< per kind: lever of a rotation that moves the surface
    Integrator integrator_;
    std::vector<double> wall_margins_;
    bool motions_wait_;  ///< some, for the bodies to settle
    AtRest settling_;
    TunnelWatch tunnels_;
    WallLoads wall_loads_;
    Inserter inserter_;
    Outlets outlets_;
    Particles particles_;
    MovingWalls walls_;
    NeighborLists lists_;
    NarrowPhaseScratch scratch_;
    EnergyLedger ledger_;
    LargestOverlap largest_overlap_;
    std::uint64_t core_overlaps_ = 0;
    double inserted_energy_ = 0.0;
};

}  // namespace dem::runtime
