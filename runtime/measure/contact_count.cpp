// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/contact_count.hpp"

#include <algorithm>

namespace dem::runtime {

std::vector<std::uint32_t> coordination_numbers(const Simulation& simulation) {
    const NeighborLists& lists = simulation.lists();
    std::vector<std::uint32_t> result(simulation.particles().size(), 0);
    for (std::uint32_t i = 0; i < result.size(); ++i) {
        for (const Adjacency::Entry entry : lists.adjacency.of(i)) {
            result[i] += lists.touching[entry.result];
        }
    }
    return result;
}

std::uint64_t contact_count(const Simulation& simulation) {
    const auto& touching = simulation.lists().touching;
    return static_cast<std::uint64_t>(
        std::count(touching.begin(), touching.end(), std::uint8_t{1}));
}

}  // namespace dem::runtime
