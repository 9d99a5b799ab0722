// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"
#include "runtime/scene.hpp"

namespace dem::runtime {

/// The random part of body k of a group. Its stream depends on the seed, the group and k alone.
class BodyDraw {
  public:
    BodyDraw(const Scene& scene, std::uint32_t group, std::uint64_t k)
        : group_(scene.insertions[group]), random_(scene.run.seed, group * streams_per_group + k) {
        body_.kind = group_.kinds[k % group_.kinds.size()];
        body_.velocity = group_.velocity;
        body_.angular_velocity = group_.angular_velocity;
        turn();
    }

    /// Draws the orientation anew; one that is given stays.
    void turn() {
        body_.orientation = group_.orientation ? *group_.orientation : random_.orientation();
    }

    const BodyPlacement& body() const { return body_; }
    Random& random() { return random_; }

  private:
    static constexpr std::uint64_t streams_per_group = 1ULL << 40U;
    const InsertionGroup& group_;
    Random random_;
    BodyPlacement body_;
};

}  // namespace dem::runtime
