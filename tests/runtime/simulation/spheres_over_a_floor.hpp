// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/runtime/simulation/scenes.hpp"

#include <utility>
#include <vector>

/// Spheres of one size over a floor: the scenes of tests that need no more.
namespace dem::scenes {

inline constexpr double small_radius = 5e-3;  // [m]

inline BodyPlacement at(double x, double y, double z) {
    BodyPlacement body;
    body.position = {x, y, z};
    return body;
}

inline Scene spheres_over_a_floor(std::vector<BodyPlacement> bodies) {
    Scene scene = one_material({1e7, 2500.0, 0.5, 0.4});
    add_kind(scene, sphere(small_radius));
    scene.walls.push_back(plane(Vec3::Zero(), Vec3::UnitZ()));
    scene.insertions.push_back(placed(std::move(bodies)));
    return scene;
}

}  // namespace dem::scenes
