// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/node_search.hpp"
#include "runtime/contact/law/contact_point.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace dem::runtime {

/// One side of a patch of a mesh wall: twice the number of the patch, plus one for the back.
using PatchSide = std::uint32_t;

inline PatchSide other_side(PatchSide side) {
    return side ^ 1U;
}

/// What a body and a mesh wall remember. All zero: no contact. A body may have several contacts
/// with one wall, as with the two faces of a corner; each is known by the sides of patches that it
/// touches, and keeps its springs when it moves from one of them to the next over an edge that
/// bulges. Should there be more contacts than places, the last place is of all the rest together.
struct MeshHistory {
    static constexpr std::size_t most_contacts = 4;
    static constexpr std::size_t most_sides = 4;
    struct Contact {
        /// The sides it touched in the last step, rising; `none` where there are fewer.
        std::array<PatchSide, most_sides> sides{};
        PatchHistory history;
    };
    static constexpr PatchSide none = std::numeric_limits<PatchSide>::max();

    std::uint64_t used = 0;  ///< contacts, the first ones
    std::array<Contact, most_contacts> contacts;

    bool touched() const { return used > 0; }
    /// The first contact that touched a side; `used` if there was none.
    std::size_t contact_of(PatchSide side) const {
        std::size_t k = 0;
        while (k < used && std::find(contacts[k].sides.begin(), contacts[k].sides.end(), side) ==
                               contacts[k].sides.end())
            ++k;
        return k;
    }
    bool knows(PatchSide side) const { return contact_of(side) < used; }
};
static_assert(std::is_trivially_copyable_v<MeshHistory>);

inline double held_energy(const MeshHistory& history) {
    double held = 0.0;
    for (std::size_t k = 0; k < history.used; ++k) held += held_energy(history.contacts[k].history);
    return held;
}

using MeshCall = Call<MeshHistory, NearCache>;

}  // namespace dem::runtime
