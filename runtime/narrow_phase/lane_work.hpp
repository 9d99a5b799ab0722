// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/lanes/one_point.hpp"
#include "runtime/contact/pairs/pair_table.hpp"
#include "runtime/particles.hpp"
#include "runtime/scene.hpp"
#include "runtime/walls/moving_walls.hpp"

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

/// What the narrow phase keeps for the contacts that it computes in lanes.
namespace dem::runtime {

/// The bodies and walls as lanes read them.
struct LaneBodies {
    const LaneKernels* kernels = nullptr;  ///< of width 1 where lanes are not for this scene
    std::vector<LaneRow> rows;             ///< per particle
    std::vector<LaneKind> kinds;           ///< per kind
    std::vector<LaneRow> wall_rows;        ///< per wall
    std::vector<LaneKind> wall_kinds;      ///< per wall

    bool in_use() const { return kernels->width > 1; }
};

LaneBodies make_lane_bodies(const Scene& scene);

/// Copies where bodies and walls are and how they move.
void update(LaneBodies& lanes, const Particles& particles, const MovingWalls& walls);

/// Which of the kernels is for a row of the table of pairs; null: none.
template <class Row>
constexpr LaneKernel LaneKernels::*kernel_of_row() {
    using A = typename Row::A;
    using B = typename Row::B;
    constexpr bool are_spheres = std::is_same_v<A, Sphere>;
    constexpr bool are_smooth =
        std::is_same_v<A, SrShape> && Row::method == ContactLaw::Method::continuous;
    if (are_spheres && std::is_same_v<B, Sphere>) return &LaneKernels::spheres;
    if (are_spheres && std::is_same_v<B, PlaneWall>) return &LaneKernels::sphere_at_plane;
    if (are_spheres && std::is_same_v<B, CylinderWall>) return &LaneKernels::sphere_in_tube;
    if (are_smooth && std::is_same_v<B, SrShape>) return &LaneKernels::smooth;
    if (are_smooth && std::is_same_v<B, PlaneWall>) return &LaneKernels::smooth_at_plane;
    if (are_smooth && std::is_same_v<B, CylinderWall>) return &LaneKernels::smooth_in_tube;
    return nullptr;
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
