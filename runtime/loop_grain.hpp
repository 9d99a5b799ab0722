// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// Elements of the time loop's loops that take some five microseconds, the grain in which threads
/// share them (common/threads/thread_team.hpp): less is done sooner than a second thread has come.
namespace dem::runtime {

/// Grain of loops over bodies: 5 to 60 ns each.
constexpr std::size_t bodies_at_a_time = 256;
/// Grain of loops over pairs that may touch: 3 ns asleep, 50 ns two spheres, up to 3 us two
/// polyhedra.
constexpr std::size_t pairs_at_a_time = 32;

}  // namespace dem::runtime
