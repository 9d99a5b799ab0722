// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"

#include <array>
#include <span>

namespace dem::runtime {

/// Which contact points hold the slots of a history in this step, in the order of their features.
struct PatchSlots {
    std::size_t count = 0;
    std::array<std::uint32_t, PatchHistory::slot_count> point;  ///< index of the contact point
    std::array<bool, PatchHistory::slot_count> known;           ///< had a slot: its spring goes on
};

/// The rule of PatchHistory: who touches keeps its slot, free slots go to the deepest points
/// without one, ties to the lower feature; a place that counts against others holds none. Moves the
/// slots that go on to their new places. `points` and slots are in the order of features, every
/// feature once.
PatchSlots choose_slots(std::span<const ContactPoint> points, PatchHistory& history);

/// What the contact remembers as one of a single point, whose slot is the first.
inline PointHistory as_point(const PatchHistory& history, const ContactLaw& law) {
    PointHistory point;
    static_cast<ContactHistory&>(point) = history;
    static_cast<SpringHistory&>(point) = history.slots[0];
    // Friction's spring lies across the normal of its slot, which frictionless contacts leave
    // alone.
    if (law.friction > 0.0) point.normal = history.slots[0].normal;
    return point;
}
/// Keeps what the contact remembers now, the place of this feature being all of it.
inline void keep_point(const PointHistory& point, std::uint64_t feature, PatchHistory& history) {
    PatchHistory::Slot& slot = history.slots[0];
    static_cast<ContactHistory&>(history) = point;
    static_cast<SpringHistory&>(slot) = point;
    slot.feature = feature;
    slot.normal = point.normal;
    history.used = 1;
}

}  // namespace dem::runtime
