// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

/// The motion of bodies of revolution computed several at a time, one in each lane (docs/lanes.md),
/// with the bits of one at a time. Bodies with three different moments of inertia, and those that
/// turn far in a step, are left to the code for one.
namespace dem::runtime {

/// What moves a kind of body.
struct KindMotion {
    double inverse_mass;    ///< [1/kg]; 0: a fixed body
    double inverse_across;  ///< inverse moments across and along the axis [1/(kg m^2)]
    double inverse_along;
    double reach;     ///< how far surface points that a rotation moves lie from the center [m]
    double is_axial;  ///< 1: the moments across the axis are equal; else 0
};

/// Particles (particles.hpp) as the plain numbers that they are in memory.
struct BodyArrays {
    double *position, *orientation, *velocity, *angular_momentum, *angular_velocity;
    const double *force, *torque, *old_force, *old_torque;
    double* travel;
    const std::uint32_t* kind;
    const KindMotion* kinds;
};

/// The most bodies that a kernel is given at once.
inline constexpr std::size_t body_block = 64;

/// Moves `count` bodies from `first` on; bit k of what is returned: body first + k is moved, the
/// others are as they were.
using BodyKernel = std::uint64_t (*)(const BodyArrays&, std::size_t first, std::size_t count,
                                     double dt);

struct BodyKernels {
    int width = 1;
    BodyKernel advance = nullptr;  ///< kick, drift and predict (integrator.hpp)
    BodyKernel correct = nullptr;
};

/// Kernels of a width, 1, 2, 4 or 8; 1: none.
const BodyKernels& body_kernels(int width);

}  // namespace dem::runtime
