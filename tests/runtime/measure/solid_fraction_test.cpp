// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/solid_fraction.hpp"

#include "runtime/measure/fill_height.hpp"
#include "runtime/measure/measures.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using scenes::at;
using scenes::spheres_over_a_floor;

constexpr double radius = scenes::small_radius;

// A sphere in the middle of a cylinder of three radii, whose core is one of one radius; and in the
// middle of a box of five radii by six, whose core is one by two.
TEST(SolidFraction, IsThatOfTheWallsNeighborhoodAndOfTheCore) {
    Scene cylinder = spheres_over_a_floor({at(0.0, 0.0, radius)});
    scenes::add_vessel(cylinder, 3.0 * radius);
    Scene box = spheres_over_a_floor({at(0.0, 0.0, radius)});
    scenes::add_box(box, {-2.5 * radius, -3.0 * radius, 0.0}, {2.5 * radius, 3.0 * radius, 1.0});
    struct Case {
        Scene* scene;
        double area, core;
    };
    for (const auto& [scene, area, core] :
         {Case{&cylinder, 9.0 * pi, 2.0 / 3.0}, Case{&box, 30.0, -1.0}}) {
        Simulation simulation(*scene, 1e-6);
        simulation.step();
        const auto vessel = find_vessel(simulation.scene());
        ASSERT_TRUE(vessel);
        const SolidFraction f = solid_fraction(simulation.particles(), simulation.scene(), *vessel,
                                               {0.0, 2.0 * radius});
        const double overall = 4.0 / 3.0 * pi / (2.0 * area);
        EXPECT_NEAR(f.overall, overall, 1e-3);
        EXPECT_NEAR(f.bulk_density, 2500.0 * f.overall, 1e-9 * f.bulk_density);
        const double core_area = core > 0.0 ? pi : 2.0;
        EXPECT_NEAR(f.near_wall * (area - core_area) + f.core * core_area, overall * area, 0.01);
        if (core > 0.0) {
            EXPECT_NEAR(f.core, core, 0.005);
            EXPECT_EQ(f.near_wall, 0.0);
        }
        // The thinnest slice is widest in the middle: pi r^2 of the cross-section.
        const SolidFraction slice = solid_fraction(simulation.particles(), simulation.scene(),
                                                   *vessel, {0.999 * radius, 1.001 * radius});
        EXPECT_NEAR(slice.overall, pi / area, 1e-3);
    }
}

TEST(SolidFraction, DoesNotCountTheAirUpToTheHighestBody) {
    std::vector<BodyPlacement> bodies;  // a full layer and one sphere high above it
    for (int k = 0; k < 9; ++k) {
        bodies.push_back(at(2.001 * radius * (k % 3 - 1), 2.001 * radius * (k / 3 - 1), radius));
    }
    bodies.push_back(at(0.0, 0.0, 20.0 * radius));
    Scene scene = spheres_over_a_floor(bodies);
    scenes::add_box(scene, {-3.1 * radius, -3.1 * radius, 0.0}, {3.1 * radius, 3.1 * radius, 1.0});
    scene.measures = {{"bed", MeasureSettings::Kind::solid_fraction, 0.01}};
    Simulation simulation(scene, 1e-6);
    const double surface = fill_height(simulation.particles(), simulation.scene()).surface;
    const SolidFraction expected = solid_fraction(simulation.particles(), simulation.scene(),
                                                  *find_vessel(simulation.scene()), {0.0, surface});
    EXPECT_EQ(measure_values(simulation, simulation.scene().measures.front()).front(),
              expected.overall);
    EXPECT_GT(expected.overall, 0.3) << "0.06 up to the highest point";
    EXPECT_EQ(measure_columns(simulation.scene()).back(), "bed_bulk_density");
}

}  // namespace
}  // namespace dem::runtime
