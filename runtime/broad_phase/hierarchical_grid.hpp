// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

struct IdPair {
    std::uint32_t i, j;  ///< i < j
    bool operator==(const IdPair& other) const = default;
    bool operator<(const IdPair& other) const { return i != other.i ? i < other.i : j < other.j; }
};

/// All pairs of boxes that touch, sorted. O(n) for any ratio of sizes, in an unbounded domain; the
/// boxes must be finite. The same for any number of threads.
std::vector<IdPair> overlapping_pairs(std::span<const Aabb> boxes);

}  // namespace dem::runtime
