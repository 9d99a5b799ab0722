// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"
#include "runtime/walls/moving_walls.hpp"

#include <cstdint>

namespace dem::runtime {

/// Everything that can touch, read only: what a contact kernel is given is gathered from here.
struct Bodies {
    const Scene& scene;
    const Particles& particles;
    const MovingWalls& walls;

    const BodyKind& kind(std::uint32_t id) const { return scene.kinds[particles.kind[id]]; }
    const ParticleTemplate& shape(std::uint32_t id) const { return scene.shapes[kind(id).shape]; }

    BodyState state(std::uint32_t id) const {
        return {particles.orientation[id], particles.velocity[id], particles.angular_velocity[id],
                kind(id).inverse_inertia};
    }

    /// Two particles, i < j.
    PairState pair(std::uint32_t i, std::uint32_t j) const {
        return {particles.position[j] - particles.position[i], state(i), state(j)};
    }
    PairState wall_pair(std::uint32_t i, std::uint32_t wall) const {
        return {walls.state[wall].position - particles.position[i], state(i),
                walls.state[wall].body};
    }

    const ContactLaw& law(std::uint32_t i, std::uint32_t j) const {
        return scene.laws.at(kind(i).material, kind(j).material);
    }
    const ContactLaw& wall_law(std::uint32_t i, std::uint32_t wall) const {
        return scene.laws.at(kind(i).material, scene.walls[wall].material);
    }
};

}  // namespace dem::runtime
