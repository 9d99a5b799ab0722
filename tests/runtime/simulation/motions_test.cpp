// SPDX-License-Identifier: BSD-3-Clause
// Bodies on walls that move and on surfaces that do.
#include "common/math/rotation.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr double friction = 0.3;
constexpr double belt_speed = 0.6;
constexpr double gravity = 9.81;

/// A flat block, or a sphere, on a floor.
Scene body_on_floor(const ParticleTemplate& shape, double height) {
    Scene scene = scenes::one_material({2e7, 1000.0, 0.3, friction});
    scenes::add_kind(scene, shape);
    BodyPlacement body;
    body.position = {0.0, 0.0, height};
    scene.insertions.push_back(scenes::placed({body}));
    scene.walls = {scenes::plane(Vec3::Zero(), Vec3::UnitZ())};
    scene.run.domain = Aabb{Vec3::Constant(-5.0), Vec3::Constant(5.0)};
    return scene;
}

Scene block_on_floor(double height) {
    return body_on_floor(scenes::convex(shapegen::make_cuboid({0.04, 0.04, 0.01}, 5e-4)), height);
}

/// A block that lies on a belt as it would at rest: while it sinks in, dashpots carry a part of its
/// weight, and they do not rub.
Scene block_on_belt() {
    Simulation standing(block_on_floor(0.5 * 0.01), 1e-5);
    while (standing.time() < 0.1) standing.step();
    Scene scene = block_on_floor(standing.particles().position[0].z());
    scene.walls[0].surface_velocity = {belt_speed, 0.0, 0.0};
    return scene;
}

// A block slides until v / (mu g); by then the belt has gone v^2 / (2 mu g) further than it has.
TEST(Belt, TakesABlockAlongAfterTheTimeOfSliding) {
    Simulation simulation(block_on_belt(), 1e-5);
    const double sliding = belt_speed / (friction * gravity);
    while (simulation.time() < 0.5 * sliding) simulation.step();
    EXPECT_NEAR(simulation.particles().velocity[0].x(), 0.5 * belt_speed, 0.01 * belt_speed);
    while (simulation.time() < 1.5 * sliding) simulation.step();
    EXPECT_NEAR(simulation.particles().velocity[0].x(), belt_speed, 1e-4 * belt_speed);
    const double behind = belt_speed * simulation.time() - simulation.particles().position[0].x();
    EXPECT_NEAR(2.0 * behind / belt_speed, sliding, 1e-3 * sliding);
    EXPECT_NEAR(simulation.particles().position[0].y(), 0.0, 1e-6);
    const Energies e = energies(simulation);
    const double mass = simulation.scene().kinds[0].mass;
    // Half of the belt's work is lost in sliding.
    EXPECT_NEAR(e.wall_work, mass * square(belt_speed), 2e-3 * mass * square(belt_speed));
    EXPECT_LT(std::abs(e.residual()), 1e-3 * e.wall_work);
}

// A sphere rolls without sliding after 2 v / (7 mu g), at 2/7 of the belt's speed.
TEST(Belt, SetsASphereRollingAsTheClosedFormSays) {
    constexpr double radius = 5e-3;
    Scene scene = body_on_floor(scenes::sphere(radius), radius);
    scene.walls[0].surface_velocity = {0.0, belt_speed, 0.0};
    Simulation simulation(std::move(scene), 2e-6);
    while (simulation.time() < 0.1) simulation.step();
    const double speed = simulation.particles().velocity[0].y();
    EXPECT_NEAR(speed, 2.0 / 7.0 * belt_speed, 1e-3 * belt_speed);
    const double behind = speed * simulation.time() - simulation.particles().position[0].y();
    const double sliding = 2.0 * belt_speed / (7.0 * friction * gravity);
    EXPECT_NEAR(2.0 * behind / speed, sliding, 0.02 * sliding);
}

TEST(Belt, IsThePlaneThatMovesAsAWhole) {
    const auto end = [](bool is_belt) {
        Scene scene = block_on_belt();
        const Vec3 velocity = scene.walls[0].surface_velocity;
        if (!is_belt) {
            scene.walls[0].surface_velocity.setZero();
            scene.walls[0].motion.pieces = {{.velocity = velocity}};
        }
        Simulation simulation(std::move(scene), 1e-5);
        while (simulation.time() < 0.1) simulation.step();
        EXPECT_EQ(simulation.walls().state[0].position.x() == 0.0, is_belt);
        return simulation.particles().position[0];
    };
    EXPECT_LT((end(true) - end(false)).norm(), 1e-9);
}

/// Spheres that fall a little way into a vessel which turns once they have settled.
Scene fill_settle_turn() {
    Scene scene = scenes::one_material({2e6, 1000.0, 0.3, 0.5});
    scenes::add_kind(scene, scenes::sphere(4e-3));
    scene.insertions.push_back(scenes::placed(scenes::column(30, 1, 20e-3, 9e-3)));
    scenes::add_vessel(scene, 20e-3);
    Motion turn;
    turn.pieces = {{.kind = MotionPiece::Kind::rotate, .axis = Vec3::UnitX(), .rate = 2.0}};
    turn.pieces[0].ramp = 0.2;
    turn.from_settled = true;
    for (Wall& wall : scene.walls) wall.motion = turn;
    return scene;
}

TEST(SettledMotion, BeginsOnceTheBodiesAreAtRestAndIsAClosedFormOfTimeSinceThen) {
    Simulation simulation(fill_settle_turn(), 2e-5);
    while (simulation.has_waiting_motion() && simulation.time() < 5.0) {
        EXPECT_EQ(simulation.walls().state[0].body.orientation.x(), 0.0);
        simulation.step();
    }
    const double settled = simulation.walls().settled;
    EXPECT_EQ(settled, simulation.time());
    EXPECT_GT(settled, 0.05);
    EXPECT_LT(settled, 4.0);
    for (const Vec3& v : simulation.particles().velocity) EXPECT_LT(v.norm(), 3e-3);
    for (int step = 0; step < 15000; ++step) simulation.step();
    const Quat turned = rotation_about(Vec3::UnitX(), 2.0 * (simulation.time() - settled - 0.1));
    const Quat found = simulation.walls().state[1].body.orientation;
    EXPECT_LT((turned.conjugate() * found).vec().norm(), 1e-14);
    const Energies e = energies(simulation);
    EXPECT_GT(std::abs(e.wall_work), 0.0);
    EXPECT_LT(std::abs(e.residual()), 1e-3 * simulation.inserted_energy());
}

TEST(SettledMotion, WaitsForWhatIsStillToBeInserted) {
    Scene scene = fill_settle_turn();
    InsertionGroup late = scenes::placed({});
    late.start = 1.7;
    BodyPlacement body;
    body.position = {0.0, 0.0, 0.09};
    late.placements = {body};
    late.kinds = {0};
    late.count = 1;
    scene.insertions.push_back(late);
    Simulation simulation(std::move(scene), 2e-5);
    while (simulation.has_waiting_motion() && simulation.time() < 5.0) simulation.step();
    EXPECT_GT(simulation.walls().settled, 1.7);
    EXPECT_EQ(simulation.particles().size(), 31U);
}

}  // namespace
}  // namespace dem::runtime
