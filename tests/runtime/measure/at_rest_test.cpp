// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/at_rest.hpp"

#include "runtime/measure/contact_count.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using scenes::at;
using scenes::spheres_over_a_floor;

constexpr double radius = scenes::small_radius;

TEST(AtRest, IsReachedAfterTheLastBounceAndNotAtTheTopOfAFlight) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 4.0 * radius)}), 5e-6);
    AtRest at_rest(simulation.scene());
    double last_touchdown = 0.0;
    while (!at_rest.was_reached() && simulation.time() < 2.0) {
        const bool touched = contact_count(simulation) > 0;
        simulation.step();
        if (!touched && contact_count(simulation) > 0) last_touchdown = simulation.time();
        at_rest.look(simulation.bodies(), simulation.time(), simulation.is_inserted());
    }
    EXPECT_TRUE(at_rest.was_reached());
    EXPECT_GT(last_touchdown, 0.1);
    EXPECT_GT(simulation.time(), last_touchdown);
    EXPECT_LT(simulation.time(), 0.6);
}

}  // namespace
}  // namespace dem::runtime
