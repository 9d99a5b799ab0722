// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

std::vector<Vec2> cylinder_outline(double radius, double height) {
    constexpr int samples = 200;
    std::vector<Vec2> outline;
    const std::array<Vec2, 4> corners = {Vec2(0.0, -0.5 * height), Vec2(radius, -0.5 * height),
                                         Vec2(radius, 0.5 * height), Vec2(0.0, 0.5 * height)};
    for (std::size_t side = 0; side < 3; ++side)
        for (int k = 0; k < samples; ++k)
            outline.emplace_back(corners[side] + (corners[side + 1] - corners[side]) * k / samples);
    outline.push_back(corners[3]);
    return outline;
}

// A hundred nodes of the end touch, eight of them hold the springs. Where those lie at one side, or
// change it with every rock of the body, they turn it and let it walk down the slope.
TEST(NodeRest, ASharpCylinderStandsOnASlopeThatFrictionHoldsByTheTwentiethPart) {
    const double radius = 3e-3;
    const double height = 10e-3;
    const SrShape cylinder = make_sr_shape(cylinder_outline(radius, height), true, 2000);
    const double mass = 1200.0 * pi * square(radius) * height;
    const double across = mass * (square(radius) / 4.0 + square(height) / 12.0);
    for (const double friction : {0.3, 1.0}) {
        ContactLaw options;
        options.friction = friction;
        const ContactLaw law = pair_law({1e7, 0.3}, {1e7, 0.3}, 0.5, options);
        const double slope = std::atan(0.3 / 1.05);
        TwoBodies bodies;
        bodies.acceleration = 9.81 * Vec3(std::sin(slope), 0.0, -std::cos(slope));
        bodies.i.inverse = inverse_inertia(mass, {across, across, 0.5 * mass * square(radius)});
        bodies.i.position.z() = 0.5 * height;
        PatchHistory history;
        NearCache cache;
        ContactScratch scratch(cylinder.nodes.count);
        const double dt = 1.2e-5;
        for (int step = 0; step < 40'000; ++step) {
            cache = {};  // no list is trusted: the test keeps no count of the way
            bodies.step(dt, [&](const PairState& pair, double h) {
                return collide(cylinder, PlaneWall{},
                               PatchCall{pair, law, h, {history, cache}, 0.0, {&scratch}});
            });
        }
        EXPECT_LT(std::hypot(bodies.i.position.x(), bodies.i.position.y()), 2e-5) << friction;
        EXPECT_LT(bodies.kinetic_energy(), 1e-14) << friction;  // falls from 0.1 mm: 3e-7 J
    }
}

}  // namespace
}  // namespace dem::test
