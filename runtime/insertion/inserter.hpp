// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <vector>

namespace dem::runtime {

/// Brings the bodies of Scene::insertions into the simulation when their time has come, never with
/// an overlap at the start. What it does depends on the scene, the state of the bodies and the time
/// alone: body k of group g draws its random numbers from a stream of its own.
class Inserter {
  public:
    explicit Inserter(const Scene& scene);

    /// When the next group or batch is due [s]; infinity when nothing is left to insert.
    double next_time() const;

    /// Appends everything that is due at `time` [s] to `particles` and returns how many bodies that
    /// were. `scene` is the one of the constructor. A batch that finds its region occupied places
    /// what fits and tries again for the rest after the group's next interval.
    /// Throws Error naming the group: a region that cannot hold what goes in at once (with how many
    /// were placed), a row of a file that overlaps another body or a wall.
    std::uint32_t insert_due(const Scene& scene, Particles& particles, double time);

    /// How many bodies of a group have not been placed (yet).
    std::uint64_t missing(std::uint32_t group) const;

    /// How many of those were due in a batch that found no room for them.
    std::uint64_t crowded_out(std::uint32_t group) const;

    /// What has been done so far, for checkpoints.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("inserter", self.groups_);
    }
    /// Whether what a checkpoint brought belongs to this scene.
    bool fits(const Scene& scene) const { return groups_.size() == scene.insertions.size(); }

  private:
    void insert_group(const Scene& scene, std::uint32_t group, Particles& particles, double time);

    struct Progress {
        std::uint64_t count = 0;   ///< bodies of the group
        std::uint64_t due = 0;     ///< asked for so far
        std::uint64_t placed = 0;  ///< so far; also the index of the next body within the group
        std::uint64_t events = 0;  ///< insertion times gone by
        double next = 0.0;         ///< [s]
    };
    std::vector<Progress> groups_;
};

}  // namespace dem::runtime
