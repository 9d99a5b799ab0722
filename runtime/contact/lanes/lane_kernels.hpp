// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"
#include "runtime/contact/law/contact_law.hpp"

#include <array>
#include <cstdint>
#include <span>

/// Contacts of one kind computed several at a time, one in each lane (docs/lanes.md). What a lane
/// computes has the bits of the row's collide(): both are made of the same templates. Lanes take a
/// contact of one point that went on from the step before; whatever else happens (it began, ended,
/// moved so far that its normal must be searched anew) is rare, and left to collide().
namespace dem::runtime {

/// What a contact in a lane reads of a body or a wall.
struct alignas(32) LaneRow {
    std::array<double, 3> position;          ///< of the center of mass, or the wall's origin [m]
    std::array<double, 3> axis;              ///< of a surface of revolution or a wall, unit
    std::array<double, 3> velocity;          ///< [m/s]
    std::array<double, 3> angular_velocity;  ///< [rad/s]
};

/// What it reads of a kind of body, or of a wall.
struct LaneKind {
    double inverse_mass = 0.0;            ///< [1/kg]
    double inverse_moment = 0.0;          ///< across the axis [1/(kg m^2)]
    double inverse_surface = 0.0;         ///< InverseInertia::surface [1/kg]
    double radius = 0.0;                  ///< bounding radius; of a sphere or a wall its own [m]
    double equivalent_diameter = 0.0;     ///< [m]
    const SupportMap* support = nullptr;  ///< of a convex surface of revolution
    double length = 0.0;                  ///< of a cylinder wall [m]
};

/// What one pair does in this step: what the sum over a particle's contacts needs, no more.
struct PairResult {
    StoredVec3 force;                ///< on i [N]
    StoredVec3 torque_i, torque_j;   ///< about the centers of mass [N m]
    double elastic_energy = 0.0;     ///< [J]
    double dissipated_energy = 0.0;  ///< during this step [J]
    double wall_work = 0.0;          ///< of a moving wall on the particle during this step [J]
};

/// The sizes of the two parts of a wall's force on a particle.
struct ForceParts {
    double normal = 0.0;  ///< of springs and dashpots along the normals [N]
    double shear = 0.0;   ///< of friction [N]
};

/// A contact for a lane: two bodies, or one and a wall, that touched in one point in the step
/// before, what they remember of it, and where its result goes.
struct LaneContact {
    const LaneRow *i, *j;
    const LaneKind *kind_i, *kind_j;
    const ContactLaw* law;
    ContactHistory* history;
    SpringHistory* spring;
    PairResult* result;
    ForceParts* parts = nullptr;  ///< of a contact with a wall
};

/// The most contacts that a kernel is given at once.
inline constexpr std::size_t lane_block = 64;

struct LaneOutcome {
    /// Bit k: contact k was computed; the others are as they were and need collide().
    std::uint64_t done = 0;
    std::array<double, lane_block> overlap;  ///< of those that were computed [m]
};

/// Computes contacts of one row of the table of pairs.
using LaneKernel = void (*)(std::span<const LaneContact>, double dt, LaneOutcome&);

/// The kernels of one width.
struct LaneKernels {
    int width = 1;  ///< contacts at a time; 1: no kernels, every contact by collide()
    LaneKernel spheres = nullptr;
    LaneKernel smooth = nullptr;  ///< two convex surfaces of revolution
    LaneKernel sphere_at_plane = nullptr;
    LaneKernel sphere_in_tube = nullptr;  ///< at the inside of a cylinder
    LaneKernel smooth_at_plane = nullptr;
    LaneKernel smooth_in_tube = nullptr;
};

/// Whether contacts under this law may go to lanes.
inline bool runs_in_lanes(const ContactLaw& law) {
    return law.friction > 0.0 && !(law.rolling.friction > 0.0);
}

/// Kernels of a width, 1, 2, 4 or 8; null where this processor has no registers as wide.
const LaneKernels* lane_kernels(int width);

/// The width of this processor's registers.
int widest_lanes();

}  // namespace dem::runtime
