// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/wall_forces.hpp"

#include "runtime/measure/energy.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"
#include "tests/support/sample_walls.hpp"

#include <memory>
#include <numeric>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

/// Spheres, candies, clumps and grains that fall into a vessel.
Scene mixed_vessel() {
    Scene scene = scenes::one_material({2e7, 1400.0, 0.6, 0.4});
    scenes::add_kind(scene, scenes::sphere(5e-3));
    scenes::add_kind(scene, scenes::candy(300));
    scenes::add_kind(scene, scenes::candy_clump(30));
    scenes::add_kind(scene, scenes::sand_grain(9e-3, 16, 3));
    std::vector<BodyPlacement> bodies = scenes::column(24, 4, 18e-3, 13.5e-3);
    for (BodyPlacement& body : bodies) body.velocity = {0.3, 0.2, -0.5};
    scene.insertions.push_back(scenes::placed(bodies));
    scenes::add_vessel(scene, 18e-3);
    return scene;
}

/// Spheres and clumps on a tray of triangles that shakes.
Scene shaken_tray() {
    Scene scene = scenes::one_material({2e7, 1400.0, 0.6, 0.4});
    scenes::add_kind(scene, scenes::sphere(5e-3));
    scenes::add_kind(scene, scenes::candy_clump(30));
    scene.insertions.push_back(scenes::placed(scenes::column(18, 2, 22e-3, 13.5e-3)));
    Wall tray;
    tray.name = "tray";
    tray.shape = MeshWall{std::make_shared<const WallMesh>(
        sample::box_inside(Vec3(-0.03, -0.03, -4e-3), Vec3(0.03, 0.03, 0.2)).wall())};
    tray.motion.pieces = {{.kind = MotionPiece::Kind::oscillate,
                           .axis = Vec3(1.0, 0.5, 0.7).normalized(),
                           .amplitude = 1e-4,
                           .frequency = 40.0}};
    tray.torque_point = {0.01, 0.02, -0.03};
    scene.walls.push_back(tray);
    return scene;
}

struct Momentum {
    Vec3 linear = Vec3::Zero();
    double mass = 0.0;
};
Momentum momentum(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    Momentum sum;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double mass = simulation.scene().kinds[p.kind[i]].mass;
        sum.linear += mass * p.velocity[i];
        sum.mass += mass;
    }
    return sum;
}

WallForce sum_of_walls(const Simulation& simulation) {
    WallForce sum;
    for (const WallForce& wall : wall_forces(simulation)) {
        sum.force += wall.force;
        sum.power += wall.power;
    }
    return sum;
}

TEST(WallForces, TheBodiesGainWhatGravityGivesAndTheWallsTake) {
    for (Scene scene : {mixed_vessel(), shaken_tray()}) {
        const Vec3 gravity = scene.run.gravity;
        constexpr double dt = 5e-6;
        Simulation simulation(std::move(scene), dt);
        const Momentum start = momentum(simulation);
        Vec3 impulse = Vec3::Zero();
        Vec3 before = sum_of_walls(simulation).force;
        double largest = 0.0;
        for (int n = 0; n < 16000; ++n) {
            simulation.step();
            const Vec3 now = sum_of_walls(simulation).force;
            // Velocities change by the mean of the forces at both ends of a step.
            impulse += dt * (start.mass * gravity - 0.5 * (before + now));
            before = now;
            largest = std::max(largest, now.norm());
        }
        const Vec3 gained = momentum(simulation).linear - start.linear;
        EXPECT_GT(largest, 0.1 * start.mass * gravity.norm());
        EXPECT_LT((gained - impulse).norm(), 1e-11 * start.mass);
    }
}

TEST(WallForces, PowerAddsUpToTheWorkOfTheWalls) {
    Simulation simulation(shaken_tray(), 5e-6);
    double work = 0.0;
    double largest = 0.0;
    for (int n = 0; n < 8000; ++n) {
        simulation.step();
        work += sum_of_walls(simulation).power * simulation.time_step();
        largest = std::max(largest, std::abs(work));
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_NEAR(work, energies(simulation).wall_work, 1e-12 * largest);
}

// The axis of the drum goes through the point of its torque: torque times speed is power.
TEST(WallForces, TheTorqueOnADrumTimesItsSpeedIsThePowerThatItGives) {
    Scene scene = mixed_vessel();
    scene.run.gravity = {0.0, -9.81, 0.0};
    const double rate = 6.0;
    for (Wall& wall : scene.walls) {
        wall.motion.pieces = {{.kind = MotionPiece::Kind::rotate, .rate = rate}};
        wall.torque_point = {0.0, 0.0, 0.4};
    }
    Simulation simulation(std::move(scene), 5e-6);
    double work = 0.0;
    double size = 0.0;
    for (int n = 0; n < 8000; ++n) {
        simulation.step();
        double torque = 0.0;
        for (const WallForce& wall : wall_forces(simulation)) torque += wall.torque.z();
        work -= torque * rate * simulation.time_step();
        size += std::abs(torque * rate * simulation.time_step());
    }
    EXPECT_GT(size, 0.0);
    EXPECT_NEAR(work, energies(simulation).wall_work, 1e-9 * size);
}

TEST(WallForces, ABedAtRestLiesOnTheFloorWithItsWeight) {
    Scene scene = scenes::one_material({2e6, 1400.0, 0.2, 0.4});
    scenes::add_kind(scene, scenes::sphere(5e-3));
    scene.insertions.push_back(scenes::placed(scenes::column(8, 1, 16e-3, 13.5e-3)));
    scenes::add_vessel(scene, 18e-3);
    Simulation simulation(std::move(scene), 2e-5);
    for (int n = 0; n < 100000; ++n) simulation.step();
    const double weight = momentum(simulation).mass * 9.81;
    const Vec3 force = sum_of_walls(simulation).force;
    EXPECT_LT((force - Vec3(0.0, 0.0, -weight)).norm(), 1e-6 * weight);
}

TEST(WallForces, ASlidingSpherePressesWithItsWeightAndShearsWithFrictionTimesIt) {
    for (const int lanes : {1, 0}) {
        Scene scene = scenes::spheres_over_a_floor({scenes::at(0.0, 0.0, scenes::small_radius)});
        scene.run.lanes = lanes;
        scene.insertions[0].placements[0].velocity = {5.0, 0.0, 0.0};
        Simulation simulation(std::move(scene), 1e-6);
        for (int n = 0; n < 40000; ++n) simulation.step();
        const double weight = momentum(simulation).mass * 9.81;
        const WallForce floor = wall_forces(simulation).front();
        EXPECT_NEAR(floor.normal, weight, 1e-3 * weight);
        EXPECT_NEAR(floor.shear, 0.4 * weight, 1e-3 * weight);
        EXPECT_NEAR(floor.force.x(), 0.4 * weight, 1e-3 * weight);
        EXPECT_NEAR(floor.force.z(), -weight, 1e-3 * weight);
    }
}

TEST(WallForces, TheyAreTheSameForAnyNumberOfThreadsAndLanes) {
    const auto values_of = [](std::vector<int> threads, int lanes) {
        Scene scene = mixed_vessel();
        scene.run.forced_threads = std::move(threads);
        scene.run.lanes = lanes;
        scene.output.wall_forces = WallForceColumns::faces;
        Simulation simulation(std::move(scene), 5e-6);
        std::vector<double> values;
        for (int n = 0; n < 4000; ++n) {
            simulation.step();
            if (n % 100 != 0) continue;
            const auto now = wall_force_values(simulation);
            values.insert(values.end(), now.begin(), now.end());
        }
        return values;
    };
    const std::vector<double> one = values_of({1}, 1);
    EXPECT_GT(std::accumulate(one.begin(), one.end(), 0.0), 0.0);
    EXPECT_EQ(one, values_of({3}, 0));
    EXPECT_EQ(one, values_of({1, 2}, 2));
}

TEST(WallForces, ASectionOfSeveralFacesHasItsSumFirst) {
    Scene scene = mixed_vessel();
    scene.walls[0].name = "vessel";
    scene.walls[1].name = "vessel.bottom";
    scene.output.wall_forces = WallForceColumns::faces;
    const std::vector<std::string> columns = wall_force_columns(scene);
    ASSERT_EQ(columns.size(), 27U);
    EXPECT_EQ(columns[0], "vessel_force_x");
    EXPECT_EQ(columns[9], "vessel.side_force_x");
    EXPECT_EQ(columns[26], "vessel.bottom_power");
    Simulation simulation(scene, 5e-6);
    for (int n = 0; n < 8000; ++n) simulation.step();
    const std::vector<double> values = wall_force_values(simulation);
    ASSERT_EQ(values.size(), 27U);
    for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(values[k], values[9 + k] + values[18 + k]);
    scene.output.wall_forces = WallForceColumns::whole;
    EXPECT_EQ(wall_force_columns(scene).size(), 9U);
    scene.output.wall_forces = WallForceColumns::none;
    EXPECT_TRUE(wall_force_columns(scene).empty());
}

// ---- Contacts one by one.

TEST(SeenContacts, TheForcesOnABodyAreThoseOfItsContactsAndItsWeight) {
    for (Scene scene : {mixed_vessel(), shaken_tray()}) {
        scene.output.contacts = true;
        Simulation simulation(std::move(scene), 2e-5);
        std::size_t seen = 0;
        for (int n = 0; n < 80; ++n) {
            for (int k = 0; k < 149; ++k) simulation.step();
            EXPECT_EQ(simulation.contacts(), nullptr);
            simulation.step(true);
            ASSERT_NE(simulation.contacts(), nullptr);
            const Particles& p = simulation.particles();
            std::vector<Vec3> force(p.size(), Vec3::Zero());
            for (std::uint32_t i = 0; i < p.size(); ++i)
                force[i] =
                    simulation.scene().kinds[p.kind[i]].mass * simulation.scene().run.gravity;
            double scale = 0.0;
            for (const SeenContact& c : *simulation.contacts()) {
                ++seen;
                const Vec3 on_i = c.force;
                force[c.i] += on_i;
                if (c.is_wall == 0) force[c.j] -= on_i;
                scale = std::max(scale, on_i.norm());
                // The place lies on both bodies or on the wall, the normal towards i.
                EXPECT_NEAR(Vec3(c.normal).norm(), 1.0, 1e-12);
                EXPECT_GT(Vec3(c.normal).dot(p.position[c.i] - Vec3(c.point)), 0.0);
                EXPECT_LT((on_i - Vec3(c.friction) - c.normal_force * Vec3(c.normal)).norm(),
                          0.05 * on_i.norm() + 1e-12);
            }
            for (std::uint32_t i = 0; i < p.size(); ++i)
                EXPECT_LT((force[i] - p.force[i]).norm(), 1e-12 * (scale + 1.0));
        }
        EXPECT_GT(seen, 100U);
    }
}

TEST(SeenContacts, LookingChangesNoBitAndThreadsNoOrder) {
    const auto run = [](std::vector<int> threads, bool looks) {
        Scene scene = shaken_tray();
        scene.output.contacts = looks;
        scene.run.forced_threads = std::move(threads);
        auto simulation = std::make_unique<Simulation>(std::move(scene), 2e-5);
        for (int n = 0; n < 7000; ++n) simulation->step(n % 3 == 0);
        return simulation;
    };
    const auto quiet = run({1}, false);
    const auto one = run({1}, true);
    const auto three = run({3}, true);
    EXPECT_EQ(quiet->state_hash(), one->state_hash());
    EXPECT_EQ(one->state_hash(), three->state_hash());
    ASSERT_NE(one->contacts(), nullptr);
    ASSERT_EQ(one->contacts()->size(), three->contacts()->size());
    EXPECT_GT(one->contacts()->size(), 5U);
    for (std::size_t k = 0; k < one->contacts()->size(); ++k) {
        const SeenContact& a = (*one->contacts())[k];
        const SeenContact& b = (*three->contacts())[k];
        EXPECT_EQ(a.i, b.i);
        EXPECT_EQ(a.j, b.j);
        EXPECT_EQ(Vec3(a.force), Vec3(b.force));
    }
}

TEST(SeenContacts, ASlidingBodySlipsAndAStandingOneDoesNot) {
    for (const double speed : {0.0, 2.0}) {
        Scene scene =
            scenes::spheres_over_a_floor({scenes::at(0.0, 0.0, 0.999 * scenes::small_radius)});
        scene.insertions[0].placements[0].velocity = {speed, 0.0, 0.0};
        scene.output.contacts = true;
        Simulation simulation(std::move(scene), 1e-6);
        for (int n = 0; n < 20; ++n) simulation.step(true);
        ASSERT_EQ(simulation.contacts()->size(), 1U);
        EXPECT_EQ(simulation.contacts()->front().slips, speed > 0.0 ? 1U : 0U);
    }
}

}  // namespace
}  // namespace dem::runtime
