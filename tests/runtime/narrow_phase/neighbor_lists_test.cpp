// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/neighbor_lists.hpp"

#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr double radius = 5e-3;

/// Two spheres, one on the other, on a floor.
Scene pile() {
    Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::sphere(radius));
    scene.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitZ()));
    std::vector<BodyPlacement> bodies(2);
    bodies[0].position = {0.0, 0.0, 0.9999 * radius};
    bodies[1].position = {1e-4, 0.0, 2.9997 * radius};
    scene.insertions.push_back(scenes::placed(bodies));
    return scene;
}

double age(const ContactHistory& history) {
    return history.phase;
}
double age(const MeshHistory& history) {
    return history.contacts[0].history.phase;
}

/// Of every pair with a history its ids and how old the contact is.
std::vector<std::pair<IdPair, double>> remembered(const NeighborLists& lists) {
    std::vector<std::pair<IdPair, double>> all;
    for_each_list(lists, [&](const auto& list) {
        for (std::uint32_t k = 0; k < list.size(); ++k) {
            const std::uint32_t history = list.history_of[k];
            if (history != list.none) all.emplace_back(list.ids[k], age(list.histories[history]));
        }
    });
    return all;
}

TEST(NeighborLists, MadeTwiceBetweenTwoStepsKeepWhatPairsRemember) {
    Simulation simulation(pile(), 1e-6);
    for (int n = 0; n < 10; ++n) simulation.step();
    NeighborLists lists = simulation.lists();
    const auto before = remembered(lists);
    ASSERT_EQ(before.size(), 2U);
    EXPECT_GT(before[0].second, 0.0);
    const BodyAabbs aabbs(simulation.scene().shapes);
    const std::vector<double> margins(2, 0.1 * radius);
    const std::vector<double> wall_margins(1, 0.0);
    for (int n = 0; n < 3; ++n) rebuild(lists, simulation.bodies(), aabbs, margins, wall_margins);
    EXPECT_EQ(remembered(lists), before);
}

}  // namespace
}  // namespace dem::runtime
