// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/simulation.hpp"

#include <cstdint>
#include <vector>

namespace dem::runtime {

/// Contacts of every particle, with particles and walls: its coordination number.
std::vector<std::uint32_t> coordination_numbers(const Simulation& simulation);

/// Pairs that touch, walls included.
std::uint64_t contact_count(const Simulation& simulation);

}  // namespace dem::runtime
