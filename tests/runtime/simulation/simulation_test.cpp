// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/simulation.hpp"

#include "common/error.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/energy.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using scenes::at;
using scenes::spheres_over_a_floor;

constexpr double radius = scenes::small_radius;

std::string error_of(Simulation& simulation, int steps) {
    try {
        for (int n = 0; n < steps; ++n) simulation.step();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Simulation, FreeFallIsExact) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 1.0)}), 1e-4);
    for (int n = 0; n < 1000; ++n) simulation.step();
    EXPECT_NEAR(simulation.particles().position[0].z(), 1.0 - 0.5 * 9.81 * 0.01, 1e-13);
    EXPECT_NEAR(simulation.particles().velocity[0].z(), -0.981, 1e-13);
}

TEST(Simulation, ARestingSphereCarriesItsWeight) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 1.001 * radius)}), 2e-6);
    for (int n = 0; n < 200000; ++n) simulation.step();
    const double weight = simulation.scene().kinds[0].mass * 9.81;
    EXPECT_NEAR(simulation.particles().force[0].z() / weight, 0.0, 1e-6);
    ASSERT_EQ(contact_count(simulation), 1U);
    EXPECT_EQ(coordination_numbers(simulation), (std::vector<std::uint32_t>{1}));
}

// Kinetic, potential, elastic and dissipated energy, less what moving walls did, stay what was
// inserted: friction, damping, rolling, a tilted wall that moves, a second body.
TEST(Simulation, EnergyLedgerClosesBetterWithSmallerSteps) {
    const auto worst_residual = [](double dt) {
        Scene scene =
            spheres_over_a_floor({at(0.0, 0.0, 3.0 * radius), at(0.3 * radius, 0.0, 5.5 * radius)});
        Wall paddle = scenes::plane({4.0 * radius, 0.0, 0.0}, Vec3(-1.0, 0.0, 0.3).normalized());
        paddle.motion.pieces = {
            {.kind = MotionPiece::Kind::translate, .velocity = {-0.4, 0.1, 0.0}}};
        scene.walls.push_back(paddle);
        Simulation simulation(std::move(scene), dt);
        double worst = 0.0;
        while (simulation.time() < 0.06) {
            simulation.step();
            worst = std::max(worst, std::abs(energies(simulation).residual()));
        }
        EXPECT_GT(energies(simulation).dissipated, 0.0);
        EXPECT_NE(energies(simulation).wall_work, 0.0);
        return worst / simulation.inserted_energy();
    };
    const double coarse = worst_residual(4e-6);
    const double fine = worst_residual(1e-6);
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, 0.4 * coarse);
}

// Every pair of kinds, one and many points, slip and stick, while a bed comes to rest.
TEST(Simulation, EnergyLedgerOfASettlingBedClosesAsTheStepShrinks) {
    const auto worst_residual = [](double dt) {
        Scene scene = scenes::one_material({2e7, 1400.0, 0.6, 0.4});
        static const ParticleTemplate candy = scenes::candy(300);
        static const ParticleTemplate peanut = scenes::peanut(300);
        scenes::add_kind(scene, candy);
        scenes::add_kind(scene, peanut);
        scenes::add_kind(scene, scenes::sphere(5e-3));
        std::vector<BodyPlacement> bodies = scenes::column(15, 3, 18e-3, 13.5e-3);
        for (BodyPlacement& body : bodies) body.velocity = {0.3, 0.2, -0.5};
        scene.insertions.push_back(scenes::placed(bodies));
        scenes::add_vessel(scene, 18e-3);
        Simulation simulation(std::move(scene), dt);
        double worst = 0.0;
        while (simulation.time() < 0.1) {
            simulation.step();
            if (simulation.steps() % 100 != 0) continue;
            worst = std::max(worst, std::abs(energies(simulation).residual()));
        }
        EXPECT_GT(energies(simulation).dissipated, 0.2 * simulation.inserted_energy());
        return worst / simulation.inserted_energy();
    };
    const double coarse = worst_residual(2e-5);
    const double fine = worst_residual(5e-6);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_LT(fine, 0.4 * coarse);
}

TEST(Simulation, ABodyThatLeavesIsNamedWithStepAndTime) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, 1.0)});
    scene.run.domain = Aabb{Vec3(-1.0, -1.0, 0.9), Vec3(1.0, 1.0, 2.0)};
    Simulation simulation(std::move(scene), 1e-3);
    const std::string message = error_of(simulation, 1000);
    EXPECT_NE(message.find("step 143, time 0.143 s: particle 0 has left the domain"),
              std::string::npos)
        << message;
}

TEST(Simulation, TooMuchOverlapIsNamedWithBothBodies) {
    Simulation pair(spheres_over_a_floor({at(0.0, 0.0, 1.0), at(0.0, 1.8 * radius, 1.0)}), 1e-6);
    EXPECT_NE(error_of(pair, 1).find("step 1, time 1e-06 s: particle 0 and particle 1 overlap by"),
              std::string::npos);
    Simulation wall(spheres_over_a_floor({at(0.0, 0.0, 0.8 * radius)}), 1e-6);
    EXPECT_NE(error_of(wall, 1).find("particle 0 and wall 'plane' overlap by"), std::string::npos);
}

TEST(Simulation, ANumberThatIsNotOneIsFoundAtOnce) {
    BodyPlacement body = at(0.0, 0.0, 1.0);
    body.velocity.x() = std::numeric_limits<double>::quiet_NaN();
    Simulation simulation(spheres_over_a_floor({body}), 1e-6);
    EXPECT_NE(error_of(simulation, 1).find("step 1"), std::string::npos);
    body = at(0.0, 0.0, 1.0);
    body.angular_velocity.x() = 1e200;
    Simulation spinning(spheres_over_a_floor({body}), 1e-6);
    EXPECT_NE(error_of(spinning, 2).find("the orientation of particle 0 is not a number"),
              std::string::npos);
}

TEST(Simulation, FixedBodiesDoNotFallAndHoldOthers) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, 0.5), at(0.0, 0.0, 0.5 + 2.1 * radius)});
    scene.kinds.push_back(scene.kinds[0]);
    scene.kinds[1].inverse_inertia = {};
    scene.insertions[0].placements[0].kind = 1;
    scene.insertions[0].kinds = {0, 1};
    Simulation simulation(std::move(scene), 5e-6);
    for (int n = 0; n < 50000; ++n) simulation.step();
    EXPECT_EQ(simulation.particles().position[0], Vec3(0.0, 0.0, 0.5));
    EXPECT_NEAR(simulation.particles().position[1].z(), 0.5 + 2.0 * radius, 2e-5);
}

}  // namespace
}  // namespace dem::runtime
