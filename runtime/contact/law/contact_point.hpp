// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace dem::runtime {

/// One contact point of a pair as the geometry found it.
struct ContactPoint {
    Vec3 position;   ///< relative to the center of mass of i [m]
    Vec3 gradient;   ///< of the overlap with respect to a shift of i, from j towards i, negated:
                     ///< the repulsive force on i acts along it. Unit length or close to it
    double overlap;  ///< [m], > 0; negated at a place between others that counts against them
    std::uint64_t
        feature;  ///< what touches (a node, a pair of spheres); the same whoever owns the pair
};

/// History of a pair that may touch in many points. All zero: no contact.
/// A point keeps its slot while it touches; free slots go to the deepest points without one, ties
/// to the lower feature. The tangential forces of the slots stand for all points: they are scaled
/// so that stiffness and Coulomb limit are those of every touching point, and act where the load of
/// all does.
struct PatchHistory : ContactHistory {
    static constexpr std::size_t slot_count = 8;
    struct Slot : SpringHistory {
        std::uint64_t feature = 0;
        StoredVec3 normal;  ///< last one of the point
    };
    std::uint64_t used = 0;  ///< slots in use, the first ones
    std::array<Slot, slot_count> slots;
};
static_assert(std::is_trivially_copyable_v<PatchHistory>);

inline double held_energy(const PatchHistory& history) {
    double held = held_energy(history.rolling);
    for (std::uint64_t k = 0; k < history.used; ++k) held += held_energy(history.slots[k]);
    return held;
}

using ContactScratch = std::vector<ContactPoint>;

/// Force of one contact point (docs/contact.md, "Force law"). `local_radius` is R* at this
/// place now.
PairContact contact_force(const ContactPoint& point, double local_radius, const PairState& pair,
                          const ContactLaw& law, double dt, PointHistory& history);

/// Force of all contact points of a pair together (docs/contact.md, "Many points").
/// `points` are in the order of their features. No points: clears the history.
PairContact contact_force(std::span<const ContactPoint> points, double local_radius,
                          const PairState& pair, const ContactLaw& law, double dt,
                          PatchHistory& history);

}  // namespace dem::runtime
