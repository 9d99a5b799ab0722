// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/threads/team_size.hpp"
#include "common/threads/thread_team.hpp"

#include <chrono>
#include <cstddef>
#include <vector>

namespace dem {

/// The threads of a loop that does much the same in every step: as many take part as make a step
/// shortest (TeamSize).
class StepTeam {
  public:
    /// `most`: threads, the caller among them; 0: as many as there are cores. `forced`, for tests:
    /// the threads of each step in turn, whatever is fastest, and every loop is shared.
    explicit StepTeam(int most, std::vector<int> forced = {});

    int most() const { return team_.most(); }
    double mean_size() const;  ///< threads of the steps so far, weighted by their wall time

    /// One step, for as long as it lives: its loops are shared, its time counts.
    class Step {
      public:
        explicit Step(StepTeam& steps);
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;
        ~Step();

      private:
        StepTeam& steps_;
        ThreadTeam::InForce in_force_;
    };

    /// A part of some steps only, which would be taken for slowness of the present team.
    class RarePart {
      public:
        explicit RarePart(StepTeam& steps);
        RarePart(const RarePart&) = delete;
        RarePart& operator=(const RarePart&) = delete;
        ~RarePart();

      private:
        StepTeam& steps_;
        std::chrono::steady_clock::time_point began_;
    };

  private:
    using Clock = std::chrono::steady_clock;

    void begin_step();
    void end_step();

    ThreadTeam team_;
    TeamSize size_;
    std::vector<int> forced_;
    std::size_t steps_ = 0;
    int threads_ = 1;  ///< of the present step
    Clock::time_point began_;
    Clock::duration rare_{};    ///< parts of the present step
    double time_ = 0.0;         ///< of all steps [s]
    double thread_time_ = 0.0;  ///< times their threads
};

}  // namespace dem
