// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/clump_clump.hpp"
#include "runtime/contact/pairs/clump_wall.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

const Elasticity rubber{5e7, 0.29};

/// What the host owns for a pair.
struct Host {
    PatchHistory history{};
    NearCache cache{};
    ContactScratch scratch = ContactScratch(20000);
    double travel = 0.0;

    PatchCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {history, cache}, travel, {&scratch}};
    }
};

InverseInertia candy_inertia() {
    const double a2 = square(6.585e-3);
    const double c2 = square(3.395e-3);
    const double mass = 1377.0 * 4.0 / 3.0 * pi * a2 * std::sqrt(c2);
    return inverse_inertia(mass, mass / 5.0 * Vec3(a2 + c2, a2 + c2, 2.0 * a2));
}

struct Impact {
    double restitution, duration;
};

/// A clump that flies along -z onto a plane, its axis upright.
Impact central_impact(const Clump& clump, double height, double e, double dt = 2e-7) {
    const ContactLaw law = pair_law(rubber, rubber, e);
    TwoBodies bodies;
    bodies.i.inverse = candy_inertia();
    bodies.i.position = {0.0, 0.0, height * (1.0 + 1e-9)};
    bodies.i.velocity = {0.0, 0.0, -0.5};
    Host host;
    Impact impact{0.0, 0.0};
    for (int step = 0; step < 100'000; ++step) {
        host.travel +=
            1.01 * dt * (bodies.i.velocity.norm() + 7e-3 * bodies.i.angular_velocity().norm());
        bodies.step(dt, [&](const PairState& pair, double h) {
            return collide(clump, PlaneWall{}, host.call(pair, law, h));
        });
        if (bodies.contact.touches())
            impact.duration += dt;
        else if (impact.duration > 0.0)
            break;
    }
    impact.restitution = bodies.i.velocity.z() / 0.5;
    return impact;
}

TEST(ClumpCollision, TheRestitutionOfACentralImpactIsThatOfTheLawForAnyNumberOfSpheres) {
    for (const double e : {0.3, 0.6, 0.9}) {
        for (const std::uint32_t count : {1U, 3U, 10U, 100U, 1000U}) {
            const Clump ring = ring_clump(4e-3, 3e-3, count);
            EXPECT_NEAR(central_impact(ring, 3e-3, e).restitution, e, 0.003) << count;
        }
        for (const std::uint32_t count : {1U, 60U, 1000U}) {
            const Clump candy = candy_clump(count);
            EXPECT_NEAR(central_impact(candy, 3.395e-3, e).restitution, e, 0.003) << count;
        }
    }
}

TEST(ClumpCollision, TheDurationOfAnImpactHardlyDependsOnTheNumberOfSpheres) {
    const double one = central_impact(candy_clump(1), 3.395e-3, 0.6).duration;
    for (const std::uint32_t count : {20U, 60U, 250U, 1000U}) {
        const double many = central_impact(candy_clump(count), 3.395e-3, 0.6).duration;
        EXPECT_NEAR(many, one, 0.15 * one) << count;
    }
}

TEST(ClumpCollision, AClumpOfOneSphereBouncesAsThatSphereDoes) {
    ContactLaw options;
    options.friction = 0.3;
    const ContactLaw law = pair_law(rubber, rubber, 0.6, options);
    const double radius = 5e-3;
    const Clump clump = ring_clump(0.0, radius, 1);
    TwoBodies start;
    start.i.inverse = solid_sphere(1377.0, radius);
    start.i.position = {0.0, 0.0, radius * (1.0 + 1e-9)};
    start.i.velocity = {0.3, -0.1, -0.5};
    start.i.angular_momentum = Vec3(3.0, -10.0, 5.0) / start.i.inverse.moments.x();
    TwoBodies a = start;
    TwoBodies b = start;
    Host host;
    PointHistory history;
    double travel = 0.0;
    for (int step = 0; step < 3000; ++step) {
        travel += 1e-6;
        host.travel = travel;
        a.step(1e-6, [&](const PairState& pair, double dt) {
            return collide(clump, PlaneWall{}, host.call(pair, law, dt));
        });
        b.step(1e-6, [&](const PairState& pair, double dt) {
            return collide(Sphere{radius}, PlaneWall{}, Call{pair, law, dt, memory_of(history)});
        });
    }
    EXPECT_FALSE(a.contact.touches());
    EXPECT_GT(a.i.velocity.z(), 0.2);
    EXPECT_NEAR((a.i.velocity - b.i.velocity).norm(), 0.0, 1e-12);
    EXPECT_NEAR((a.i.angular_velocity() - b.i.angular_velocity()).norm(), 0.0, 1e-9);
}

// Two clumps of 60 spheres fly at each other at random attitudes and off center.
TEST(ClumpCollision, AnElasticBounceKeepsTheEnergy) {
    const Clump clump = candy_clump(60);
    const ContactLaw law = pair_law(rubber, rubber, 1.0);
    Random random(5, 0);
    double sum = 0.0;
    int bounces = 0;
    for (int pair_number = 0; bounces < 20; ++pair_number) {
        ASSERT_LT(pair_number, 200);
        TwoBodies bodies;
        bodies.i.inverse = bodies.j.inverse = candy_inertia();
        bodies.i.orientation = random.orientation();
        bodies.j.orientation = random.orientation();
        const Vec3 towards = random.direction();
        bodies.j.position =
            13.2e-3 * towards + random.uniform(0.0, 4e-3) * towards.unitOrthogonal();
        bodies.i.velocity = 0.1 * towards;
        bodies.j.velocity = -0.1 * towards;
        Host host;
        const double before = bodies.kinetic_energy();
        const double dt = 1e-6;
        bool touched = false;
        for (int step = 0; step < 80'000; ++step) {
            const double spin =
                bodies.i.angular_velocity().norm() + bodies.j.angular_velocity().norm();
            host.travel +=
                1.01 * dt * (bodies.i.velocity.norm() + bodies.j.velocity.norm() + 6.6e-3 * spin);
            bodies.step(dt, [&](const PairState& pair, double h) -> PairContact {
                if (host.travel < host.cache.clear_until) return {};
                return collide(clump, clump, host.call(pair, law, h));
            });
            if (touched && !bodies.contact.touches()) break;
            touched = touched || bodies.contact.touches();
        }
        if (!touched) continue;
        ++bounces;
        sum += std::abs(bodies.kinetic_energy() / before - 1.0);
    }
    RecordProperty("mean_energy_error", std::to_string(sum / bounces));
    EXPECT_LT(sum / bounces, 2e-6);
}

}  // namespace
}  // namespace dem::test
