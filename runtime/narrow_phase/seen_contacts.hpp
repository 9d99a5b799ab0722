// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/broad_phase/hierarchical_grid.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/narrow_phase/bodies.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

/// A contact as it was computed, world frame. Bodies are known by their ids.
struct SeenContact {
    std::uint32_t i = 0;
    std::uint32_t j = 0;        ///< a particle, or an index of Scene::walls
    std::uint32_t is_wall = 0;  ///< flag
    std::uint16_t slips = 0;    ///< flag: friction is at its limit
    std::uint16_t begins = 0;   ///< flag: the pair did not touch in the step before
    StoredVec3 center_i;        ///< [m]
    StoredVec3 center_j;        ///< of a particle; with a wall the point of contact [m]
    StoredVec3 point;           ///< where the load acts [m]
    StoredVec3 normal;          ///< unit, from j towards i
    StoredVec3 force;           ///< on i [N]
    StoredVec3 friction;        ///< part of the force that friction is [N]
    StoredVec3 velocity;        ///< of i relative to j at the point [m/s]
    /// Sum over the points of the forces along their normals [N]: positive pushes apart; at the end
    /// of an impact the dashpot may pull.
    double normal_force = 0.0;
    double friction_limit = 0.0;  ///< at which friction slips [N]
    double overlap = 0.0;         ///< [m]
};

/// Of which pairs a step notes its contacts.
enum class Looks : std::uint8_t { at_none, at_walls, at_all };

/// A pair whose contacts are noted.
struct SeenPair {
    IdPair ids;
    bool is_wall;
    bool begins;
};

/// Notes the contacts of a pair as they were computed.
void note(std::span<const PairContact> contacts, const SeenPair& pair, const Bodies& bodies,
          std::vector<SeenContact>& seen);

/// Sorts contacts that threads have noted: those of particles by rising ids, then those with walls
/// by rising id of the particle. The contacts of one pair must lie together, in their own order.
void put_in_order(std::vector<SeenContact>& seen);

/// Leaves out the contacts of particles that are not among those with these ids, which rise.
void forget_missing(std::span<const std::uint32_t> ids, std::vector<SeenContact>& seen);

}  // namespace dem::runtime
