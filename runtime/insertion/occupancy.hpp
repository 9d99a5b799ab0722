// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/insertion/placement_grid.hpp"
#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace dem::runtime {

/// Bodies and walls at one moment, and whether there is room for one more body. The answers are
/// those of the contact kernels; bounding spheres only save asking them.
class Occupancy {
  public:
    /// The walls at `time` [s] and the bodies whose bounding spheres reach into `room`.
    Occupancy(const Scene& scene, const Particles& particles, const Aabb& room, double time);

    void add(const BodyPlacement& body);
    bool is_empty() const { return residents_.empty(); }  ///< of bodies

    /// Number of a body that `body` overlaps: particles of the constructor by their id, then those
    /// added, counted on from the number of particles; nullopt: none.
    std::optional<std::uint32_t> overlapped_body(const BodyPlacement& body) const;

    /// The first wall of the scene that `body` overlaps; nullptr: none.
    const Wall* overlapped_wall(const BodyPlacement& body) const;

    bool is_free(const BodyPlacement& body) const {
        return overlapped_wall(body) == nullptr && !overlapped_body(body);
    }

  private:
    struct Resident {
        std::uint32_t id;
        BodyPlacement body;
    };
    const ParticleTemplate& shape_of(const BodyPlacement& body) const {
        return scene_.shapes[scene_.kinds[body.kind].shape];
    }
    void add(std::uint32_t id, const BodyPlacement& body);

    const Scene& scene_;
    std::vector<WallState> walls_;
    std::vector<Resident> residents_;
    PlacementGrid grid_;
    std::uint32_t next_id_;
};

}  // namespace dem::runtime
