// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "common/shapes/particle_template.hpp"

#include <vector>

namespace dem::runtime {

/// Boxes that hold whole bodies: exact for spheres, clumps and convex surfaces of revolution, for
/// others the box of the circular cylinder about the axis that holds the shape.
class BodyAabbs {
  public:
    explicit BodyAabbs(const std::vector<ParticleTemplate>& shapes);

    /// Box of shape number `shape` at a pose in the world.
    Aabb box(std::uint32_t shape, const Vec3& position, const Quat& orientation) const;

  private:
    /// Where a shape lies along its axis and how far from it [m].
    struct Cylinder {
        double low, high, radius;
    };
    const std::vector<ParticleTemplate>* shapes_;
    std::vector<Cylinder> cylinders_;  ///< per shape; used for non-convex ones
};

}  // namespace dem::runtime
