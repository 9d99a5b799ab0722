// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/narrow_phase/bodies.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace dem::runtime {

/// A ball inside every body of a kind, in its own frame.
struct InscribedBall {
    Vec3 center = Vec3::Zero();
    double radius = 0.0;  ///< [m]
};

/// Finds bodies that go through a mesh wall within a step, which contacts cannot see.
class TunnelWatch {
  public:
    explicit TunnelWatch(const Scene& scene);

    struct Tunnel {
        std::uint32_t particle;
        std::uint32_t wall;
    };
    /// The first body whose inscribed ball had its center on one side of a triangle before the last
    /// step of `dt` and has it on the other side now, `time` [s]. Costs nothing where no wall is a
    /// mesh, and little for bodies that move by less than keeps them from doing so.
    std::optional<Tunnel> find(const Bodies& bodies, double time, double dt) const;

  private:
    std::optional<std::uint32_t> crossed_wall(const Bodies& bodies, std::uint32_t particle,
                                              double time, double dt) const;
    bool is_fast(const Bodies& bodies, std::uint32_t particle, double dt) const;

    std::vector<std::uint32_t> walls_;  ///< those that are meshes
    std::vector<InscribedBall> balls_;  ///< per kind
    /// A ball that touches has its center at least this far from the wall, in its radii.
    double least_distance_ = 0.0;
};

}  // namespace dem::runtime
