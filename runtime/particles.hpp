// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

/// State of every body, one array per quantity, in the order of ids. World frame, SI. Masses and
/// inertias are those of the body's kind (Scene::kinds).
struct Particles {
    /// How many bodies came before this one: never given twice, whoever left in the meantime.
    std::vector<std::uint32_t> id;
    std::uint32_t next_id = 0;
    std::vector<Vec3> position;          ///< of the center of mass [m]
    std::vector<Quat> orientation;       ///< body -> world
    std::vector<Vec3> velocity;          ///< [m/s]
    std::vector<Vec3> angular_momentum;  ///< about the center of mass [kg m^2/s]
    std::vector<Vec3> angular_velocity;  ///< [rad/s]; follows from orientation, momentum and kind
    std::vector<Vec3> force;             ///< [N], gravity included
    std::vector<Vec3> torque;            ///< about the center of mass [N m]
    std::vector<Vec3> old_force;         ///< of the step before, for the velocity correction
    std::vector<Vec3> old_torque;
    std::vector<std::uint32_t> kind;   ///< index into Scene::kinds
    std::vector<std::uint32_t> group;  ///< index into Scene::insertions

    /// Bound on the length of the path of any surface point since the particle was inserted [m]:
    /// every drift adds |v| dt, and |w| dt times the bounding radius where a rotation moves the
    /// surface (not for spheres), with the velocities that the drift really used.
    std::vector<double> travel;

    std::uint32_t size() const { return static_cast<std::uint32_t>(position.size()); }

    /// Adds one body. The force starts as zero: who inserts bodies into a running simulation lets
    /// Simulation set their weight.
    void append(std::uint32_t kind_index, std::uint32_t group_index, const BodyPlacement& placement,
                const BodyKind& body_kind);

    /// Takes out the bodies that are marked.
    void remove(std::span<const std::uint8_t> leaving);
};

}  // namespace dem::runtime
