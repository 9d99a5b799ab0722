// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/pairs/pair_table.hpp"
#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

/// What the narrow phase keeps for the contacts that it computes in lanes.
namespace dem::runtime {

/// The bodies as lanes read them.
struct LaneBodies {
    const LaneKernels* kernels = nullptr;  ///< of width 1 where lanes are not for this scene
    std::vector<LaneRow> rows;             ///< per particle
    std::vector<LaneKind> kinds;           ///< per kind

    bool in_use() const { return kernels->width > 1; }
};

LaneBodies make_lane_bodies(const Scene& scene);

/// Copies where the bodies are and how they move.
void update(LaneBodies& lanes, const Particles& particles);

/// The kernel for a row of the table of pairs; null: the row has none.
template <class Row>
LaneKernel lane_kernel(const LaneKernels& kernels) {
    using A = typename Row::A;
    using B = typename Row::B;
    if constexpr (!std::is_same_v<typename Row::History, PointHistory>) {
        return nullptr;
    } else if constexpr (std::is_same_v<A, Sphere> && std::is_same_v<B, Sphere>) {
        return kernels.spheres;
    } else if constexpr (std::is_same_v<A, SrShape> && std::is_same_v<B, SrShape>) {
        return kernels.smooth;
    } else {
        return nullptr;
    }
}

/// Contacts of a list that one thread gathers for a kernel.
struct LaneBlock {
    std::array<LaneContact, lane_block> contacts;
    std::array<std::uint32_t, lane_block> pair;  ///< of each, in its list
    std::size_t count = 0;
    LaneOutcome outcome;
    std::uint64_t computed = 0;  ///< contacts of the last step that kernels were given
    std::uint64_t rare = 0;      ///< of them left to collide()
};

}  // namespace dem::runtime
