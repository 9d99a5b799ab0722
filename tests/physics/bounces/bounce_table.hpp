// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/physics/bounces/bounce.hpp"

#include <array>
#include <vector>

namespace dem::test {

using namespace runtime;

/// What many bounces of one pair of kinds did.
struct BounceSummary {
    std::uint64_t count = 0;  ///< that touched, not too deep
    std::uint64_t too_deep = 0;
    std::uint64_t cores_met = 0;    ///< left out as well
    double worst_with_cores = 0.0;  ///< jump among those
    double mean_change = 0.0, worst_change = 0.0, worst_jump = 0.0;
    std::uint64_t large = 0;      ///< with a jump above 1e-3
    std::array<Bounce, 3> worst;  ///< by jump
};

/// Throws `count` bounces with the seeds from `first` on, shared with the team in force.
BounceSummary bounces(const BounceSettings& settings, std::uint64_t first, std::uint64_t count);

/// Whether the kernel of a pair is one of its own: by nodes a surface of revolution is one of them,
/// whatever the other is.
inline bool is_own_pair(Kind i, Kind j) {
    return !is_wall(i) && (j != Kind::nodes || (i != Kind::smooth && i != Kind::sharp));
}

/// Calls visit(i, j) for every pair of kinds, walls second.
template <class Visit>
void for_every_pair(const Visit& visit) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        for (std::size_t j = i; j < kinds.size(); ++j)
            if (is_own_pair(kinds[i], kinds[j])) visit(kinds[i], kinds[j]);
    }
}

void print_header();
void print_row(const BounceSettings& settings, const BounceSummary& summary);

}  // namespace dem::test
