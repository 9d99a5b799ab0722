// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/fill_height.hpp"

#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using scenes::at;
using scenes::spheres_over_a_floor;

constexpr double radius = scenes::small_radius;

TEST(FillHeight, OfSpheresOnAFloor) {
    std::vector<BodyPlacement> bodies;
    for (int n = 0; n < 12; ++n) bodies.push_back(at(0.0, 0.02 * n, radius + 1e-3 * n));
    Simulation simulation(spheres_over_a_floor(bodies), 1e-6);
    const FillHeight height = fill_height(simulation.particles(), simulation.scene());
    EXPECT_DOUBLE_EQ(height.highest, 2.0 * radius + 11e-3);
    EXPECT_NEAR(height.top_ten, 2.0 * radius + 6.5e-3, 1e-15);
}

// One sphere in the corner of a box and in a cylinder: the surface seen from above is the upper
// half's, pi r^2 (r + z) less the cap's pi r^3 / 3, over the cross-section.
TEST(FillHeight, OfTheSurfaceIsTheVolumeBelowIt) {
    const double below = pi * square(radius) * (radius + 2.0 / 3.0 * radius);
    Scene box = spheres_over_a_floor({at(radius, radius, radius)});
    box.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitX()));
    box.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitY()));
    box.walls.push_back(scenes::plane({4.0 * radius, 0.0, 0.0}, -Vec3::UnitX()));
    box.walls.push_back(scenes::plane({0.0, 3.0 * radius, 0.0}, -Vec3::UnitY()));
    Scene cylinder = spheres_over_a_floor({at(radius, 0.0, radius)});
    scenes::add_vessel(cylinder, 2.0 * radius);
    for (auto& [scene, area] : {std::pair{&box, 12.0 * square(radius)},
                                std::pair{&cylinder, 4.0 * pi * square(radius)}}) {
        Simulation simulation(*scene, 1e-6);
        simulation.step();
        const FillHeight height = fill_height(simulation.particles(), simulation.scene());
        EXPECT_NEAR(height.surface, below / area, 2e-2 * below / area);
    }
}

}  // namespace
}  // namespace dem::runtime
