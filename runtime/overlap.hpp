// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <string>

/// How far bodies overlap by the laws of Hertz and of linear springs when they are taken as the
/// spheres of their volumes, and what keeps that below a limit.
namespace dem::runtime {

/// Two bodies that meet centrally, or a body and a wall.
struct Encounter {
    double mass = 0.0;            ///< effective [kg]
    double radius = 0.0;          ///< effective [m]
    double smaller_radius = 0.0;  ///< of the two spheres [m]
    std::uint32_t material_i = 0, material_j = 0;
};

/// Kinds i and j of bodies. A fixed one is as heavy as a wall.
Encounter encounter(const Scene& scene, std::uint32_t i, std::uint32_t j);
/// Kind i of bodies and a wall of a material.
Encounter encounter_with_wall(const Scene& scene, std::uint32_t i, std::uint32_t material);

/// The overlap that an elastic impact reaches, in smaller radii. `speed`: at which the bodies
/// approach when they overlap by `before` [m] already [m/s].
double impact_overlap(const Scene& scene, const Encounter& e, double speed, double before = 0.0);

/// The overlap under a force that rests on the contact [N], in smaller radii.
double load_overlap(const Scene& scene, const Encounter& e, double force);

/// Why two bodies that approach at `speed` [m/s] overlap by more than the scene allows, `relative`
/// smaller radii, and what is expected instead, no softer than foreseen_overlap expects it. `dt`:
/// the time step [s].
std::string overlap_cause(const Scene& scene, const Encounter& e, double speed, double relative,
                          double dt);

/// A line for a person about the largest overlap of the fastest impact to expect and under the
/// weight of all bodies, with a warning and what helps where it is above the limit. "" where no
/// body moves.
std::string foreseen_overlap(const Scene& scene);

}  // namespace dem::runtime
