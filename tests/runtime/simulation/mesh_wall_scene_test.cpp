// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/random.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/sample_walls.hpp"

#include <memory>

#include <gtest/gtest.h>

#ifndef SHAKEN_ROWS
#define SHAKEN_ROWS 4
#define SHAKEN_SECONDS 0.1
#endif

namespace dem::runtime {
namespace {

Wall mesh_wall(const sample::Surface& surface) {
    Wall wall;
    wall.name = "mesh";
    wall.shape = MeshWall{std::make_shared<const WallMesh>(surface.wall())};
    return wall;
}

/// Balls and clumps in turn, in rows over the origin.
Scene bodies_in_rows(int rows, double restitution) {
    Scene scene = scenes::one_material({2e7, 1400.0, restitution, 0.3});
    scenes::add_kind(scene, scenes::sphere(4e-3));
    scenes::add_kind(scene, scenes::candy_clump(30));
    std::vector<BodyPlacement> bodies;
    for (int k = 0; k < rows * rows * rows; ++k) {
        BodyPlacement body;
        body.kind = static_cast<std::uint32_t>(k % 2);
        body.position =
            14e-3 * Vec3(k % rows - 0.5 * (rows - 1), k / rows % rows - 0.5 * (rows - 1),
                         k / rows / rows - 0.5 * (rows - 1));
        body.orientation = Random(5, static_cast<std::uint64_t>(k)).orientation();
        body.velocity = Random(6, static_cast<std::uint64_t>(k)).direction();
        bodies.push_back(body);
    }
    scene.insertions.push_back(scenes::placed(bodies));
    return scene;
}

TEST(MeshWallScene, AClosedVesselThatShakesLosesNobodyAndItsLedgerCloses) {
    Scene scene = bodies_in_rows(SHAKEN_ROWS, 0.6);
    const double room = 7e-3 * SHAKEN_ROWS;
    const Vec3 half(room + 4e-3, room + 4e-3, room + 12e-3);
    scene.walls.push_back(mesh_wall(sample::box_inside(-half, half)));
    MotionPiece& shake = scene.walls[0].motion.pieces.emplace_back();
    shake.kind = MotionPiece::Kind::oscillate;
    shake.axis = Vec3(1.0, 0.5, 2.0).normalized();
    shake.amplitude = 2e-3;
    shake.frequency = 30.0;
    Simulation simulation(std::move(scene), 5e-6);
    while (simulation.time() < SHAKEN_SECONDS) simulation.step();
    const Vec3 moved = simulation.walls().state[0].position;
    for (const Vec3& x : simulation.particles().position)
        EXPECT_TRUE(((x - moved).cwiseAbs().array() < half.array()).all());
    const Energies e = energies(simulation);
    EXPECT_GT(std::abs(e.wall_work), 0.0);
    EXPECT_LT(std::abs(e.residual()),
              1e-3 * (simulation.inserted_energy() + std::abs(e.wall_work)));
}

TEST(MeshWallScene, AMovingPlateDragsBodiesAsAPlaneDoes) {
    using Kind = MotionPiece::Kind;
    for (const auto kind : {Kind::translate, Kind::rotate, Kind::oscillate}) {
        const auto made = [&](Wall wall) {
            Scene scene = bodies_in_rows(2, 0.6);
            wall.position = {0.01, -0.02, -0.02};
            wall.motion.pieces = {{.kind = kind,
                                   .velocity = {0.2, 0.1, 0.3},
                                   .axis = kind == Kind::rotate ? Vec3(0.2, 0.1, 1.0).normalized()
                                                                : Vec3(0.0, 0.6, 0.8),
                                   .point = {0.02, 0.0, 0.0},
                                   .rate = 5.0,
                                   .amplitude = 1e-3,
                                   .frequency = 50.0}};
            scene.walls.push_back(wall);
            scene.run.domain = Aabb{Vec3::Constant(-10.0), Vec3::Constant(10.0)};
            return scene;
        };
        Simulation mesh(made(mesh_wall(sample::plate({-0.5, -0.5}, {0.5, 0.5}, 40, 37))), 1e-5);
        Simulation plane(made(scenes::plane(Vec3::Zero(), Vec3::UnitZ())), 1e-5);
        double largest = 0.0;
        for (int n = 0; n < 5000; ++n) {
            mesh.step();
            plane.step();
            for (std::uint32_t i = 0; i < mesh.particles().size(); ++i)
                largest = std::max(
                    largest, (mesh.particles().position[i] - plane.particles().position[i]).norm());
        }
        EXPECT_LT(largest, 1e-9) << static_cast<int>(kind);
    }
}

std::string error_of(Scene scene, double dt, int steps) {
    return message_of<Error>([&] {
        Simulation simulation(std::move(scene), dt);
        for (int n = 0; n < steps; ++n) simulation.step();
    });
}

TEST(MeshWallScene, WhoeverGoesThroughAWallInOneStepEndsTheRunWithALine) {
    for (const std::uint32_t kind : {0U, 1U}) {
        Scene scene = bodies_in_rows(2, 0.6);
        scene.insertions[0].placements.resize(1);
        scene.insertions[0].count = 1;
        BodyPlacement& body = scene.insertions[0].placements[0];
        body.kind = kind;
        body.position = {0.001, 0.002, 0.05};
        body.velocity = {0.0, 0.0, -100.0};
        scene.walls.push_back(mesh_wall(sample::plate({-0.5, -0.5}, {0.5, 0.5}, 4, 3)));
        scene.run.domain = Aabb{Vec3::Constant(-10.0), Vec3::Constant(10.0)};
        // 40 mm a step.
        const std::string message = error_of(scene, 4e-4, 10);
        EXPECT_NE(message.find("step 2, time 0.0008 s: particle 0 has gone through wall 'mesh'"),
                  std::string::npos)
            << message;
        // The wall may be the one that moves.
        scene.insertions[0].placements[0].velocity.setZero();
        scene.walls[0].motion.pieces = {
            {.kind = MotionPiece::Kind::translate, .velocity = {0.0, 0.0, 100.0}}};
        EXPECT_NE(error_of(scene, 4e-4, 10).find("has gone through wall 'mesh'"),
                  std::string::npos);
    }
}

TEST(MeshWallScene, BodiesThatFlyPastAWallOrStayOnTheirSideGoThroughNothing) {
    Scene scene = bodies_in_rows(2, 0.6);
    scene.insertions[0].placements.resize(1);
    scene.insertions[0].count = 1;
    BodyPlacement& body = scene.insertions[0].placements[0];
    body.kind = 0;
    body.position = {0.6, 0.0, 0.05};
    body.velocity = {0.0, 0.0, -100.0};
    scene.walls.push_back(mesh_wall(sample::plate({-0.5, -0.5}, {0.5, 0.5}, 4, 3)));
    scene.run.domain = Aabb{Vec3::Constant(-10.0), Vec3::Constant(10.0)};
    EXPECT_EQ(error_of(scene, 4e-4, 10), "");
}

}  // namespace
}  // namespace dem::runtime
