// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"
#include "tests/physics/random_scenes/random_scene.hpp"
#include "tests/physics/random_scenes/scene_report.hpp"

#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#ifndef RANDOM_SCENES
#define RANDOM_SCENES 10
#define RANDOM_SCENE_STEPS 6000
#define RANDOM_SCENE_DIVISOR 60
#define RANDOM_SCENE_RESIDUAL 1e-3
#define RESTING_SCENES 1
#endif

// docs/reliability.md, "Random scenes".
namespace dem::test {

using namespace runtime;

namespace {

constexpr SceneSteps scene_steps{RANDOM_SCENE_STEPS, RANDOM_SCENE_DIVISOR};

/// Momentum and, about the origin, angular momentum.
std::pair<Vec3, Vec3> momenta(const Simulation& simulation) {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 momentum = simulation.scene().kinds[p.kind[i]].mass * p.velocity[i];
        linear += momentum;
        angular += p.position[i].cross(momentum) + p.angular_momentum[i];
    }
    return {linear, angular};
}

/// Steps a scene to its end; calls look(simulation) now and then.
template <class Look>
void run(Scene scene, const Look& look) {
    scene.run.time_step_divisor = scene_steps.divisor;
    const double dt = time_step(scene).value;
    Simulation simulation(std::move(scene), dt);
    for (int step = 0; step < scene_steps.count; ++step) {
        simulation.step();
        if (step % 20 == 0) look(simulation);
    }
}

TEST(RandomScenes, KeepTheirEnergyLedgerAndTheirBodies) {
    int touched = 0;
    int crushed = 0;
    for (std::uint64_t seed = 0; seed < RANDOM_SCENES; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const SceneReport r = report_of(random_scene(seed, true), scene_steps);
        EXPECT_EQ(r.bodies, kinds_per_scene * bodies_per_kind);
        EXPECT_LT(r.residual, r.cores_met ? 0.1 : RANDOM_SCENE_RESIDUAL);
        // What is hit twice by something much heavier leaves with four times its speed.
        EXPECT_LT(r.fastest, 4.0 * fastest);
        touched += r.touched ? 1 : 0;
        crushed += r.crushed ? 1 : 0;
    }
    EXPECT_GT(touched, RANDOM_SCENES / 2);
    EXPECT_LE(crushed, RANDOM_SCENES / 200);  // seed 102
}

TEST(RandomScenes, ComeToRest) {
    for (std::uint64_t seed = 0; seed < RESTING_SCENES; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const SceneReport r = report_of(resting_scene(seed), {60'000, 20.0});
        EXPECT_EQ(r.bodies, kinds_per_scene * bodies_per_kind);
        EXPECT_FALSE(r.crushed);
        EXPECT_LT(r.moving, 1e-3);
    }
}

TEST(RandomScenes, KeepTheirMomentumInFreeSpace) {
    for (std::uint64_t seed = 0; seed < RANDOM_SCENES; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::optional<std::pair<Vec3, Vec3>> before;
        double size = 0.0;
        run(random_scene(seed, false), [&](const Simulation& simulation) {
            const auto now = momenta(simulation);
            if (!before) {
                before = now;
                size = now.second.norm() + largest_radius(simulation.scene()) * now.first.norm();
            }
            EXPECT_LT((now.first - before->first).norm(), 1e-11 * now.first.norm());
            EXPECT_LT((now.second - before->second).norm(), 1e-6 * size);
        });
    }
}

}  // namespace
}  // namespace dem::test
