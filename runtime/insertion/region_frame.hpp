// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"
#include "runtime/scene.hpp"

#include <optional>

namespace dem::runtime {

/// A region as insertion sees it: a box along three orthogonal axes, cut by a round side when it is
/// a cylinder (whose axis is the third). A body belongs inside with its whole volume.
class RegionFrame {
  public:
    explicit RegionFrame(const Region& region);

    const Vec3& size() const { return size_; }  ///< of the box [m]

    /// World position of a point given by its distances from the lower corner of the box.
    Vec3 at(const Vec3& local) const { return corner_ + axes_ * local; }

    /// How far a body reaches from its center of mass along the axes [m].
    struct Reach {
        Vec3 below, above;
    };
    Reach reach(const ParticleTemplate& shape, const Quat& orientation) const;

    /// Whether a body lies wholly inside.
    bool contains(const ParticleTemplate& shape, const BodyPlacement& body) const;

    /// Whether a body is within the round side (true for a box).
    bool is_within_side(const ParticleTemplate& shape, const BodyPlacement& body) const;

    /// A position, uniform over those where the body with its orientation lies wholly inside;
    /// nullopt when the try failed (the round side) or there are none.
    std::optional<Vec3> sample(Random& random, const ParticleTemplate& shape,
                               const Quat& orientation) const;

  private:
    Mat3 axes_;  ///< columns
    Vec3 corner_;
    Vec3 size_;
    double radius_ = 0.0;  ///< of the round side [m]; 0: a box
};

}  // namespace dem::runtime
