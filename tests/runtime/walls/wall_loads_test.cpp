// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall_loads.hpp"

#include "runtime/measure/wall_forces.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/sample_walls.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr double radius = 5e-3;

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A sphere that touches a plate of 20 x 2 squares, 200 mm long and 20 mm wide about y = 0.
Scene sphere_on_a_plate(double friction, const Vec3& velocity, double modulus = 1e7) {
    Scene scene = scenes::one_material({modulus, 2500.0, 0.5, friction});
    scenes::add_kind(scene, scenes::sphere(radius));
    BodyPlacement body;
    body.position = {5e-3, 5e-3, radius};
    body.velocity = velocity;
    scene.insertions.push_back(scenes::placed({body}));
    Wall plate;
    plate.name = "plate";
    plate.shape = MeshWall{
        std::make_shared<const WallMesh>(sample::plate({0.0, -10e-3}, {0.2, 10e-3}, 20, 2).wall())};
    scene.walls.push_back(plate);
    scene.output.wall_contacts = true;
    return scene;
}

double weight(const Simulation& simulation) {
    return simulation.scene().kinds[0].mass * 9.81;
}

TEST(WallLoads, ASphereThatSlidesLeavesItsWeightAndWorkOnTheTrianglesItPasses) {
    Simulation simulation(sphere_on_a_plate(0.4, {2.0, 0.0, 0.0}), 1e-6);
    double normal = 0.0;
    double shear = 0.0;
    while (simulation.time() < 0.04) {
        simulation.step();
        const WallForce plate = wall_forces(simulation).front();
        normal += plate.normal * simulation.time_step();
        shear += plate.shear * simulation.time_step();
    }
    const WallLoads& loads = simulation.wall_loads();
    ASSERT_EQ(loads.size(), 80U);
    EXPECT_NEAR(sum(loads.normal()), normal, 1e-12 * normal);
    EXPECT_NEAR(sum(loads.shear()), shear, 1e-12 * shear);
    EXPECT_NEAR(sum(loads.normal()), weight(simulation) * 0.04, 5e-3 * weight(simulation) * 0.04);
    // It slips all the way: friction is mu times the load.
    EXPECT_NEAR(sum(loads.friction_work()), 0.4 * sum(loads.sliding_work()),
                2e-2 * sum(loads.friction_work()));
    const double gone = simulation.particles().position[0].x();
    const WallMesh& mesh = *std::get<MeshWall>(simulation.scene().walls[0].shape).mesh;
    std::size_t touched = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        const bool is_passed = middle.y() > 0.0 && middle.x() < gone;
        if (loads.normal()[t] == 0.0) continue;
        ++touched;
        EXPECT_TRUE(is_passed || middle.x() < gone + 10e-3) << middle.transpose();
        EXPECT_GT(middle.y(), 0.0);
    }
    EXPECT_GE(touched, 7U);
}

TEST(WallLoads, AnImpactIsBookedWithFinniesShareOfItsEnergy) {
    for (const double angle : {0.2, 0.3, 0.5, 1.2, 0.5 * pi}) {
        const double speed = 3.0;
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        Scene scene = sphere_on_a_plate(0.3, speed * Vec3(cosine, 0.0, -sine), 1e9);
        scene.run.gravity = Vec3::Zero();
        Simulation simulation(std::move(scene), 1e-7);
        for (int n = 0; n < 3000; ++n) simulation.step();
        EXPECT_GT(simulation.particles().velocity[0].z(), 0.0);
        const double share = std::tan(angle) <= 1.0 / 3.0
                                 ? std::sin(2.0 * angle) - 3.0 * sine * sine
                                 : cosine * cosine / 3.0;
        const double energy = simulation.scene().kinds[0].mass * speed * speed;
        EXPECT_NEAR(sum(simulation.wall_loads().impact_energy()), share * energy, 1e-12 * energy);
    }
}

TEST(WallLoads, AWallThatTurnsKeepsWhatItsTrianglesHave) {
    Scene scene = sphere_on_a_plate(0.4, Vec3::Zero());
    scene.walls[0].orientation = Quat(0.0, 0.0, 0.0, 1.0);  // half a turn about z
    Simulation simulation(std::move(scene), 1e-6);
    for (int n = 0; n < 2000; ++n) simulation.step();
    EXPECT_EQ(sum(simulation.wall_loads().normal()), 0.0);  // the plate lies elsewhere

    scene = sphere_on_a_plate(0.4, Vec3::Zero());
    scene.walls[0].orientation = Quat(0.0, 0.0, 0.0, 1.0);
    scene.walls[0].position = {10e-3, 10e-3, 0.0};
    Simulation turned(std::move(scene), 1e-6);
    for (int n = 0; n < 2000; ++n) turned.step();
    const WallMesh& mesh = *std::get<MeshWall>(turned.scene().walls[0].shape).mesh;
    const auto& normal = turned.wall_loads().normal();
    const auto t =
        static_cast<std::uint32_t>(std::max_element(normal.begin(), normal.end()) - normal.begin());
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    EXPECT_LT((middle - Vec3(5e-3, 5e-3, 0.0)).norm(), 5e-3);
    EXPECT_GT(normal[t], 0.0);
}

TEST(WallLoads, TheyAreTheSameForAnyNumberOfThreadsAndChangeNoBit) {
    const auto run = [](std::vector<int> threads, bool loads) {
        Scene scene = sphere_on_a_plate(0.4, {0.3, 0.0, 0.0});
        std::vector<BodyPlacement> bodies;
        for (int k = 0; k < 30; ++k) {
            BodyPlacement body;
            body.position = {6e-3 + 11e-3 * (k % 15), -5e-3 + 10.5e-3 * (k / 15), 1.2 * radius};
            body.velocity = {0.1 * (k % 3), 0.0, -0.3};
            bodies.push_back(body);
        }
        scene.insertions[0] = scenes::placed(bodies);
        scene.output.wall_contacts = loads;
        scene.run.forced_threads = std::move(threads);
        auto simulation = std::make_unique<Simulation>(std::move(scene), 2e-6);
        for (int n = 0; n < 5000; ++n) simulation->step();
        return simulation;
    };
    const auto one = run({1}, true);
    const auto three = run({3}, true);
    EXPECT_EQ(one->state_hash(), run({1}, false)->state_hash());
    EXPECT_EQ(one->wall_loads().normal(), three->wall_loads().normal());
    EXPECT_EQ(one->wall_loads().sliding_work(), three->wall_loads().sliding_work());
    EXPECT_EQ(one->wall_loads().impact_energy(), three->wall_loads().impact_energy());
    EXPECT_GT(sum(one->wall_loads().impact_energy()), 0.0);
}

}  // namespace
}  // namespace dem::runtime
