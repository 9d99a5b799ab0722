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

}  // namespace dem::runtime
