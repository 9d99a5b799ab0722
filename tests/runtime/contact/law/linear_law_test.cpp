// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/law/tangential.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

constexpr double radius = 3e-3;

InverseInertia ball() {
    InverseInertia inverse = solid_sphere(1000.0, radius);
    inverse.surface = square(radius) * inverse.moments.x();
    return inverse;
}

struct Impact {
    Vec3 velocity = Vec3::Zero();  ///< of the surface of i relative to j's, at the end
    double duration = 0.0;
};

/// Two equal balls meet head on, the surface of one sliding along the other's.
Impact impact(const ContactLaw& law, double slide) {
    TwoBodies bodies;
    bodies.i.inverse = bodies.j.inverse = ball();
    bodies.j.position = {2.0 * radius * (1.0 + 1e-12), 0.0, 0.0};
    bodies.i.velocity = {0.1, slide, 0.0};
    bodies.j.velocity = {-0.1, 0.0, 0.0};
    PointHistory history;
    const double dt = 1e-7;
    Impact result;
    for (int step = 0; step < 1'000'000; ++step) {
        bodies.step(dt, [&](const PairState& pair, double h) {
            return collide(Sphere{radius}, Sphere{radius}, Call{pair, law, h, memory_of(history)});
        });
        if (bodies.contact.touches())
            result.duration += dt;
        else if (result.duration > 0.0)
            break;
    }
    const Vec3 n = Vec3::UnitX();
    result.velocity = bodies.i.velocity - bodies.j.velocity +
                      bodies.i.angular_velocity().cross(radius * n) +
                      bodies.j.angular_velocity().cross(radius * n);
    return result;
}

TEST(LinearLaw, GivesTheRestitutionAndTheContactTimeItIsDerivedFrom) {
    for (const double e : {0.3, 0.6, 1.0}) {
        const double stiffness = 1e4;
        const Impact found = impact(linear_law(stiffness, e, 0.6), 0.0);
        EXPECT_NEAR(-found.velocity.x() / 0.2, e, 2e-3);
        const double reduced = 0.5 / ball().mass;
        const double log_e = std::log(e);
        EXPECT_NEAR(found.duration, std::sqrt(reduced * (pi * pi + log_e * log_e) / stiffness),
                    5e-7);
    }
}

// [GC] Sec. 6: stick without slip turns the tangential velocity round by e_t in the contact time.
TEST(LinearLaw, GivesTheTangentialRestitution) {
    for (const double e_t : {0.3, 0.6, 1.0}) {
        ContactLaw options;
        options.friction = 1e3;
        const Impact found = impact(linear_law(1e4, 0.8, e_t, options), 0.05);
        EXPECT_NEAR(found.velocity.y() / 0.05, -e_t, 3e-3);
    }
}

// docs/contact.md, "Without slip".
TEST(LinearLaw, ForceAndPushOfASpringThatLetsGoAreTheGradientOfItsEnergy) {
    const double k_t = 3e3;
    const double ratio = 7.0;
    const double overlap = 1e-6;
    const double reach = ratio * overlap;
    const double h = 1e-6 * overlap;
    for (const double s : {1.001 * reach, 2.0 * reach, 1e3 * reach}) {
        const auto energy = [&](double length, double d) {
            return letting_go(k_t, length, ratio, d).energy;
        };
        const LettingGo go = letting_go(k_t, s, ratio, overlap);
        const double by_length = (energy(s + h, overlap) - energy(s - h, overlap)) / (2.0 * h);
        const double by_overlap = (energy(s, overlap + h) - energy(s, overlap - h)) / (2.0 * h);
        EXPECT_NEAR(go.force, by_length, 1e-4 * k_t * reach);
        EXPECT_NEAR(go.push, by_overlap, 1e-4 * ratio * k_t * reach);
    }
    // It begins where the plain spring is, without a jump of energy or force.
    const LettingGo begins = letting_go(k_t, reach, ratio, overlap);
    EXPECT_DOUBLE_EQ(begins.energy, 0.5 * k_t * reach * reach);
    EXPECT_DOUBLE_EQ(begins.force, k_t * reach);
    EXPECT_EQ(begins.push, 0.0);
    EXPECT_EQ(letting_go(k_t, 1e-5, ratio, 0.0).energy, 0.0);
}

TEST(LinearLaw, RefusesNumbersOutOfRange) {
    EXPECT_THROW(linear_law(0.0, 0.5, 0.5), Error);
    EXPECT_THROW(linear_law(1e4, 0.0, 0.5), Error);
    EXPECT_THROW(linear_law(1e4, 1.1, 0.5), Error);
    EXPECT_THROW(linear_law(1e4, 0.5, -0.1), Error);
    EXPECT_THROW(linear_law(NAN, 0.5, 0.5), Error);
}

}  // namespace
}  // namespace dem::test
