// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/simulation.hpp"

#include <string>
#include <vector>

namespace dem::runtime {

/// What all bodies together do to a wall, world frame.
struct WallForce {
    Vec3 force = Vec3::Zero();   ///< on the wall [N]
    Vec3 torque = Vec3::Zero();  ///< on the wall about Wall::torque_point [N m]
    double normal = 0.0;         ///< sum over the contacts of the normal force, > 0: pushes [N]
    double shear = 0.0;          ///< sum over the contacts of the size of the friction [N]
    double power = 0.0;          ///< that the moving wall gives to the bodies [W]
};

/// Of every wall of the scene in the last step. Contacts are summed by rising id of the body, so
/// that a sum does not depend on lists or threads. The power is the work of the last step over its
/// length, none before the first step; its sum over the steps is the energy ledger's wall work.
std::vector<WallForce> wall_forces(const Simulation& simulation);

/// The name of every wall of the scene as files have it: NAME, or NAME.FACE where a [wall.NAME] has
/// several faces (the side of a cylinder with ends is NAME.side).
std::vector<std::string> face_names(const Scene& scene);

/// Columns that history.csv has for walls (OutputSettings::wall_forces): for each [wall.NAME]
/// NAME_force_x, _force_y, _force_z, _torque_x, _torque_y, _torque_z, _normal, _shear and _power of
/// all its faces together; where faces are asked for, the same of each face NAME.FACE after them.
std::vector<std::string> wall_force_columns(const Scene& scene);

/// What they hold now.
std::vector<double> wall_force_values(const Simulation& simulation);

}  // namespace dem::runtime
