// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace dem::runtime {

using namespace shapegen;

namespace {

constexpr double edge = 9e-3;

/// Cuboids one above the other with small gaps, turned a little against each other; linear law.
Scene stack(std::uint32_t count) {
    Scene scene = scenes::one_material({5e7, 2500.0, 0.5, 0.3});
    ContactLaw options;
    options.friction = 0.3;
    scene.laws.set(0, 0, linear_law(1e5, 0.5, 0.6, options));
    scenes::add_kind(scene, scenes::convex(make_cuboid(Vec3::Constant(edge), 0.02 * edge)));
    std::vector<BodyPlacement> bodies;
    for (std::uint32_t n = 0; n < count; ++n) {
        BodyPlacement body;
        body.position.z() = 1.002 * edge * (n + 0.5);
        body.orientation = rotation({0.0, 0.0, 0.02 * (n % 3)});
        bodies.push_back(body);
    }
    scene.insertions.push_back(scenes::placed(bodies));
    scene.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitZ()));
    return scene;
}

void expect_standing(std::uint32_t count, double seconds) {
    const Scene scene = stack(count);
    const double dt = time_step(scene).value;
    Simulation simulation(scene, dt);
    for (double t = 0.0; t < seconds; t += dt) simulation.step();
    const Particles& p = simulation.particles();
    double fastest = 0.0;
    for (std::uint32_t n = 0; n < count; ++n) {
        const Vec3 place(0.0, 0.0, edge * (n + 0.5));
        EXPECT_LT((p.position[n] - place).norm(), 0.01 * edge * std::max(1.0, 0.1 * n)) << n;
        EXPECT_NEAR(p.velocity[n].z(), 0.0, 1e-6) << n;
        fastest = std::max(fastest, p.velocity[n].norm());
    }
    testing::Test::RecordProperty("largest_velocity", std::to_string(fastest));
}

TEST(CuboidStack, OfTenComesToRestAndStands) {
    expect_standing(10, 0.5);
}

}  // namespace
}  // namespace dem::runtime
