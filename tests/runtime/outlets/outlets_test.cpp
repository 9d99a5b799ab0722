// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/outlets/outlets.hpp"

#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr double radius = 3e-3;

Outlet below(double height) {
    return {.name = "drain", .where = "test.ini:1", .place = HalfSpace{{0.0, 0.0, height}}};
}

/// Spheres of one sort at rest at the start.
Scene spheres_at(const std::vector<Vec3>& places) {
    Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::sphere(radius));
    std::vector<BodyPlacement> bodies(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) bodies[k].position = places[k];
    scene.insertions.push_back(scenes::placed(bodies));
    return scene;
}

TEST(Outlets, TakeOutBodiesWhenTheirCentersGetThereWithTheEnergyTheyHave) {
    const std::vector<double> heights = {0.09, 0.01, 0.16, 0.04};
    std::vector<Vec3> places;
    for (const double height : heights) places.emplace_back(height, 0.0, height);
    Scene scene = spheres_at(places);
    scene.outlets.push_back(below(0.0));
    const double dt = 1e-4;
    const double mass = scene.kinds[0].mass;
    Simulation simulation(scene, dt);
    double energy = 0.0;
    std::vector<double> left_at(heights.size(), 0.0);
    std::vector<std::uint32_t> before = simulation.particles().id;
    for (int k = 0; k < 2000; ++k) {
        simulation.step();
        const std::vector<std::uint32_t>& now = simulation.particles().id;
        for (const std::uint32_t id : before) {
            if (!std::ranges::binary_search(now, id)) left_at[id] = simulation.time();
        }
        before = now;
    }
    EXPECT_EQ(simulation.particles().size(), 0U);
    for (std::size_t k = 0; k < heights.size(); ++k) {
        EXPECT_NEAR(left_at[k], std::sqrt(2.0 * heights[k] / 9.81), dt);
        energy += mass * 9.81 * heights[k];
    }
    const Energies e = energies(simulation);
    EXPECT_NEAR(e.removed / energy, 1.0, 1e-12);
    EXPECT_NEAR(e.residual() / energy, 0.0, 1e-12);
    EXPECT_EQ(simulation.outlets().total(0).bodies, 4);
    EXPECT_NEAR(simulation.outlets().total(0).mass / mass, 4.0, 1e-14);
}

// Half of a bed goes at once, with contacts to the half that stays.
TEST(Outlets, CloseTheLedgerOfABedWhoseContactsTheyCut) {
    std::vector<Vec3> places;
    for (int n = 0; n < 60; ++n)
        places.emplace_back(6.3e-3 * (n % 3 - 1), 6.3e-3 * (n / 3 % 3 - 1) + 1e-4 * n,
                            6.2e-3 * (n / 9) + 4e-3);
    Scene scene = spheres_at(places);
    scenes::add_box(scene, {-10e-3, -10e-3, 0.0}, {10e-3, 16e-3, 0.2});
    scene.outlets.push_back({.name = "corner",
                             .where = "test.ini:1",
                             .place = BoxRegion{{{0.0, -1.0, -1.0}, {1.0, 1.0, 1e-2}}}});
    Simulation simulation(scene, 2e-5);
    std::uint32_t most_at_once = 0;
    for (int k = 0; k < 20000; ++k) {
        const std::uint32_t before = simulation.particles().size();
        simulation.step();
        most_at_once = std::max(most_at_once, before - simulation.particles().size());
    }
    const Energies e = energies(simulation);
    const std::int64_t gone = simulation.outlets().total(0).bodies;
    EXPECT_GT(gone, 20);
    EXPECT_GT(most_at_once, 0U);
    EXPECT_EQ(gone + simulation.particles().size(), 60);
    EXPECT_NEAR(e.residual() / e.inserted, 0.0, 1e-3);
    EXPECT_GT(e.removed, 0.0);
}

// A body that stays is pushed by what is there alone.
TEST(Outlets, LeaveNoForceOfWhoIsGone) {
    Scene scene = spheres_at({{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0 * radius * (1.0 - 1e-4)}});
    scene.run.gravity = Vec3::Zero();
    scene.outlets.push_back(below(1e-9));
    Simulation simulation(scene, 1e-6);
    const Energies before = energies(simulation);
    EXPECT_GT(before.elastic, 0.0);
    simulation.step();
    ASSERT_EQ(simulation.particles().id, std::vector<std::uint32_t>{1});
    EXPECT_EQ(simulation.particles().force[0], Vec3(0.0, 0.0, 0.0));
    const Vec3 velocity = simulation.particles().velocity[0];
    simulation.step();
    EXPECT_EQ(simulation.particles().velocity[0], velocity);
    const Energies after = energies(simulation);
    EXPECT_EQ(after.elastic, 0.0);
    // What the removed contact still held went with it.
    EXPECT_NEAR(after.removed / (before.elastic - after.translational), 1.0, 1e-6);
}

TEST(Outlets, CountWhatPassesAPlaneLessWhatComesBack) {
    Scene scene = spheres_at({{0.0, 0.0, 0.0}, {0.02, 0.0, 0.0}});
    for (BodyPlacement& body : scene.insertions[0].placements) body.velocity = {0.0, 0.0, 1.0};
    Outlet gate{.name = "gate",
                .where = "test.ini:1",
                .kind = Outlet::Kind::flow,
                .place = HalfSpace{{0.0, 0.0, 0.02}}};
    scene.outlets.push_back(gate);
    gate.radius = 0.015;
    scene.outlets.push_back(gate);
    Simulation simulation(scene, 1e-4);
    while (simulation.time() < 0.1) simulation.step();
    EXPECT_EQ(simulation.outlets().total(0).bodies, 2);
    EXPECT_EQ(simulation.outlets().total(1).bodies, 1) << "the other one passes beside the disc";
    EXPECT_NEAR(simulation.outlets().total(0).mass / scene.kinds[0].mass, 2.0, 1e-15);
    while (simulation.time() < 0.25) simulation.step();
    EXPECT_EQ(simulation.outlets().total(0).bodies, 0);
    EXPECT_EQ(simulation.outlets().total(1).bodies, 0);
    EXPECT_EQ(simulation.particles().size(), 2U) << "nobody is taken out";
}

TEST(Outlets, NeverGiveAnIdTwice) {
    Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::sphere(radius));
    InsertionGroup group;
    group.name = "rain";
    group.where = "test.ini:1";
    group.mode = InsertionGroup::Mode::batches;
    group.kinds = {0};
    group.count = 50;
    group.batch = 5;
    group.every = 0.01;
    group.region = CylinderRegion{{0.0, 0.0, 0.03}, {0.0, 0.0, 0.06}, 0.03};
    scene.insertions.push_back(group);
    scene.outlets.push_back(below(0.0));
    Simulation simulation(scene, 1e-4);
    std::vector<std::uint32_t> seen;
    for (int k = 0; k < 3000; ++k) {
        simulation.step();
        const std::vector<std::uint32_t>& ids = simulation.particles().id;
        EXPECT_TRUE(std::ranges::is_sorted(ids));
        std::vector<std::uint32_t> together;
        std::ranges::set_union(seen, ids, std::back_inserter(together));
        seen = together;
    }
    EXPECT_EQ(simulation.particles().size(), 0U);
    EXPECT_EQ(seen.size(), 50U);
    EXPECT_EQ(seen.back(), 49U);
    EXPECT_EQ(simulation.outlets().total(0).bodies, 50);
}

TEST(Outlets, LeaveFixedBodiesAlone) {
    Scene scene = spheres_at({{0.0, 0.0, -0.01}, {0.05, 0.0, 0.001}});
    scene.kinds.push_back(scene.kinds[0]);
    scene.kinds[1].inverse_inertia = {};
    scene.insertions[0].placements[0].kind = 1;
    scene.outlets.push_back(below(0.0));
    Simulation simulation(scene, 1e-4);
    while (simulation.time() < 0.05) simulation.step();
    EXPECT_EQ(simulation.particles().id, std::vector<std::uint32_t>{0});
}

TEST(Outlets, OfTheDomainTakeOutWhoLeavesIt) {
    Scene scene = spheres_at({{0.0, 0.0, 0.01}, {0.05, 0.0, 0.5}});
    scene.run.domain = Aabb{{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}};
    scene.run.domain_exit = DomainExit::remove;
    Simulation simulation(scene, 1e-4);
    while (simulation.time() < 0.1) simulation.step();
    EXPECT_EQ(simulation.particles().id, std::vector<std::uint32_t>{1});
    EXPECT_EQ(simulation.outlets().names(), std::vector<std::string>{"domain"});
    EXPECT_EQ(simulation.outlets().total(0).bodies, 1);
}

TEST(Outlets, AreReachedHoweverFarTheyAre) {
    Scene scene = spheres_at({{0.0, 0.0, 0.01}});
    scenes::add_box(scene, {-0.1, -0.1, 0.0}, {0.1, 0.1, 0.1});
    scene.walls.erase(scene.walls.begin() + 4);  // the bottom
    scene.outlets.push_back(below(-3.0));
    Simulation simulation(scene, 1e-3);
    while (simulation.time() < 0.9) simulation.step();
    EXPECT_EQ(simulation.outlets().total(0).bodies, 1);
}

TEST(Outlets, HoldWhatIsInTheirPlace) {
    const Outlet slab = below(0.5);
    EXPECT_TRUE(holds(slab, Vec3(7.0, 0.0, 0.4)));
    EXPECT_FALSE(holds(slab, Vec3(7.0, 0.0, 0.5)));
    EXPECT_FALSE(holds(slab, Vec3::Constant(std::nan(""))));
    const CylinderRegion tilted{{0.0, 0.0, 0.0}, {1.0, 0.0, 1.0}, 0.1};
    EXPECT_TRUE(contains(tilted, Vec3(0.5, 0.09, 0.5)));
    EXPECT_FALSE(contains(tilted, Vec3(0.5, 0.11, 0.5)));
    EXPECT_FALSE(contains(tilted, Vec3(1.01, 0.0, 1.01)));
    EXPECT_FALSE(contains(tilted, Vec3(-0.01, 0.0, -0.01)));
    EXPECT_TRUE(may_hold(slab, tilted));
    EXPECT_FALSE(may_hold(slab, CylinderRegion{{0.0, 0.0, 0.51}, {0.0, 0.0, 1.0}, 0.1}));
    EXPECT_TRUE(may_hold(slab, CylinderRegion{{0.0, 0.0, 0.55}, {1.0, 0.0, 0.55}, 0.1}));
}

}  // namespace
}  // namespace dem::runtime
