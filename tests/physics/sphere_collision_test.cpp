// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <array>
#include <tuple>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

struct Extremes {
    double overlap = 0.0, force = 0.0, time = 0.0;
};

/// Runs until the contact is over.
template <class Collide>
Extremes run_collision(TwoBodies& bodies, double dt, const Collide& collide) {
    Extremes e;
    bool touched = false;
    for (int step = 0; step < 10'000'000; ++step) {
        bodies.step(dt, collide);
        e.overlap = std::max(e.overlap, bodies.contact.overlap);
        e.force = std::max(e.force, bodies.contact.force.norm());
        if (bodies.contact.touches()) {
            touched = true;
            e.time += dt;
        } else if (touched) {
            return e;
        }
    }
    ADD_FAILURE() << "the bodies did not part";
    return e;
}

/// Two equal spheres, the first at the origin, the second touching it along `direction`.
TwoBodies sphere_pair(double radius, double density, const Vec3& direction) {
    TwoBodies b;
    b.i.inverse = b.j.inverse = solid_sphere(density, radius);
    b.j.position = direction * 2.0 * radius * (1.0 + 1e-9);
    return b;
}

// Chung & Ooi (2011), test 1: two equal elastic spheres head on at 10 m/s each.
class ChungOoiSpheres : public ::testing::TestWithParam<std::tuple<Elasticity, double, Extremes>> {
};

TEST_P(ChungOoiSpheres, HeadOnImpactGivesTheHertzExtremes) {
    const auto [material, density, expected] = GetParam();
    const Sphere sphere{0.01};
    TwoBodies b = sphere_pair(sphere.radius, density, Vec3::UnitX());
    b.i.velocity = {10.0, 0.0, 0.0};
    b.j.velocity = {-10.0, 0.0, 0.0};
    const ContactLaw law = pair_law(material, material, 1.0);
    PointHistory history;
    const Extremes e = run_collision(b, 1e-8, [&](const PairState& pair, double dt) {
        return collide(sphere, sphere, Call{pair, law, dt, memory_of(history)});
    });
    EXPECT_NEAR(e.overlap, expected.overlap, 1e-4 * expected.overlap);
    EXPECT_NEAR(e.force, expected.force, 1e-4 * expected.force);
    EXPECT_NEAR(e.time, expected.time, 1e-3 * expected.time);
    EXPECT_NEAR(b.i.velocity.x(), -10.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(GlassAndLimestone, ChungOoiSpheres,
                         ::testing::Values(std::tuple{Elasticity{4.8e10, 0.20}, 2800.0,
                                                      Extremes{274.11e-6, 10.697e3, 40.34e-6}},
                                           std::tuple{Elasticity{2.0e10, 0.25}, 2500.0,
                                                      Extremes{368.30e-6, 7.108e3, 54.20e-6}}));

// Chung & Ooi (2011), test 2: an elastic sphere on a rigid plane at 0.2 m/s.
class ChungOoiPlane : public ::testing::TestWithParam<std::tuple<Elasticity, double, Extremes>> {};

TEST_P(ChungOoiPlane, ImpactOnAPlaneGivesTheHertzExtremes) {
    const auto [material, density, expected] = GetParam();
    const Sphere sphere{0.1};
    TwoBodies b;
    b.i.inverse = solid_sphere(density, sphere.radius);
    b.i.position = {0.0, 0.0, sphere.radius};
    b.i.velocity = {0.0, 0.0, -0.2};
    ContactLaw law = pair_law(material, material, 1.0);
    law.youngs_modulus *= 2.0;  // rigid plane
    PointHistory history;
    const Extremes e = run_collision(b, 1e-7, [&](const PairState& pair, double dt) {
        return collide(sphere, PlaneWall{}, Call{pair, law, dt, memory_of(history)});
    });
    EXPECT_NEAR(e.overlap, expected.overlap, 1e-4 * expected.overlap);
    EXPECT_NEAR(e.force, expected.force, 1e-4 * expected.force);
    EXPECT_NEAR(e.time, expected.time, 1e-3 * expected.time);
}

INSTANTIATE_TEST_SUITE_P(Alloys, ChungOoiPlane,
                         ::testing::Values(std::tuple{Elasticity{7e10, 0.30}, 2699.0,
                                                      Extremes{49.717e-6, 11.370e3, 731.7e-6}},
                                           std::tuple{Elasticity{4e10, 0.35}, 1800.0,
                                                      Extremes{52.123e-6, 7.233e3, 767.1e-6}}));

// Chung & Ooi (2011), test 3: the nominal restitution is what comes out.
TEST(SphereCollision, ReboundHasTheNominalRestitution) {
    const Sphere sphere{2.5e-3};
    for (double e = 0.2; e < 1.05; e += 0.1) {
        TwoBodies b;
        b.i.inverse = solid_sphere(4000.0, sphere.radius);
        b.i.position = {0.0, 0.0, sphere.radius};
        b.i.velocity = {0.0, 0.0, -3.9};
        const ContactLaw law = pair_law({3.8e11, 0.23}, {3.8e11, 0.23}, std::min(e, 1.0));
        PointHistory history;
        run_collision(b, 1e-9, [&](const PairState& pair, double dt) {
            return collide(sphere, PlaneWall{}, Call{pair, law, dt, memory_of(history)});
        });
        EXPECT_NEAR(b.i.velocity.z() / 3.9, std::min(e, 1.0), 2e-3);
    }
}

TEST(SphereCollision, CuttingThePullRaisesTheRestitutionAsDocumented) {
    const Sphere sphere{2.5e-3};
    for (const auto& [nominal, measured] :
         {std::pair{0.3, 0.397}, {0.5, 0.550}, {0.7, 0.718}, {0.9, 0.902}}) {
        TwoBodies b;
        b.i.inverse = solid_sphere(1000.0, sphere.radius);
        b.i.position = {0.0, 0.0, sphere.radius};
        b.i.velocity = {0.0, 0.0, -1.0};
        ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, nominal);
        law.limit_force = true;
        PointHistory history;
        run_collision(b, 1e-7, [&](const PairState& pair, double dt) {
            return collide(sphere, PlaneWall{}, Call{pair, law, dt, memory_of(history)});
        });
        EXPECT_NEAR(b.i.velocity.z(), measured, 1.5e-3);
    }
}

TEST(SphereCollision, AnElasticContactLastsTheCollisionPhaseAtAnySpeed) {
    const Sphere sphere{2.5e-3};
    for (const double speed : {0.01, 0.3, 3.0}) {
        TwoBodies b = sphere_pair(sphere.radius, 1000.0, Vec3::UnitZ());
        b.i.velocity = {0.0, 0.0, speed};
        const ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);
        PointHistory history;
        double phase = 0.0;
        const double dt = 2e-7;
        run_collision(b, dt, [&](const PairState& pair, double h) {
            const PairContact c = collide(sphere, sphere, Call{pair, law, h, memory_of(history)});
            if (c.touches()) phase = history.phase;
            return c;
        });
        EXPECT_NEAR(phase, 2.0 * pi / std::sqrt(5.0), 0.01);
    }
}

// A sphere set down sliding at v0 rolls without slip after 2 v0 / (7 mu g), then at 5/7 v0.
TEST(SphereCollision, SlidingSphereStartsRollingWhenItShould) {
    const Sphere sphere{5e-3};
    const double mu = 0.2;
    const double g = 9.81;
    const double v0 = 0.1;
    TwoBodies b;
    b.i.inverse = solid_sphere(1000.0, sphere.radius);
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.5);
    law.friction = mu;
    const double stiffness = 4.0 / 3.0 * law.youngs_modulus * std::sqrt(sphere.radius);
    const double resting = std::pow(g / b.i.inverse.mass / stiffness, 2.0 / 3.0);
    b.i.position = {0.0, 0.0, sphere.radius - resting};
    b.i.velocity = {v0, 0.0, 0.0};
    b.acceleration = {0.0, 0.0, -g};
    b.i.force = Vec3::Zero();
    PointHistory history;
    const double dt = 2e-6;
    const auto slip = [&] { return b.i.velocity.x() - sphere.radius * b.i.angular_velocity().y(); };
    double rolling_since = -1.0;
    for (int k = 0; k < 20'000; ++k) {
        b.step(dt, [&](const PairState& pair, double h) {
            return collide(sphere, PlaneWall{}, Call{pair, law, h, memory_of(history)});
        });
        if (rolling_since < 0.0 && slip() < 1e-3 * v0) rolling_since = (k + 1) * dt;
    }
    EXPECT_NEAR(rolling_since, 2.0 * v0 / (7.0 * mu * g), 0.01 * 2.0 * v0 / (7.0 * mu * g));
    EXPECT_NEAR(b.i.velocity.x(), 5.0 / 7.0 * v0, 2e-3 * v0);
}

/// A pair with every kind of motion in it.
TwoBodies oblique_pair(std::uint64_t seed) {
    Random random(7, seed);
    TwoBodies b = sphere_pair(3e-3, 2000.0, random.direction());
    const Vec3 approach = b.j.position.normalized();
    b.i.velocity = 0.5 * approach + 0.4 * random.direction();
    b.j.velocity = -0.5 * approach + 0.4 * random.direction();
    for (Body* body : {&b.i, &b.j})
        body->angular_momentum = 100.0 * random.direction() / body->inverse.moments.x();
    return b;
}

// What comes out must not depend on the step: the tangential spring has a limit for dt -> 0 even
// where damping and friction compete from the first touch on.
TEST(SphereCollision, ObliqueImpactConvergesAsTheStepShrinks) {
    const Sphere sphere{3e-3};
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        std::array<Vec3, 2> out;
        for (const int k : {0, 1}) {
            TwoBodies b = oblique_pair(seed);
            PointHistory history;
            run_collision(b, k == 0 ? 1e-6 : 2e-8, [&](const PairState& pair, double dt) {
                return collide(sphere, sphere, Call{pair, law, dt, memory_of(history)});
            });
            out[static_cast<std::size_t>(k)] = b.i.velocity;
        }
        EXPECT_LT((out[0] - out[1]).norm(), 3e-3 * out[1].norm());
    }
}

TEST(SphereCollision, MomentumAndAngularMomentumAreKept) {
    const Sphere sphere{3e-3};
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        TwoBodies b = oblique_pair(seed);
        const double mass = 1.0 / b.i.inverse.mass;
        const auto momentum = [&] { return Vec3(mass * (b.i.velocity + b.j.velocity)); };
        const auto angular = [&] {
            return Vec3(mass *
                            (b.i.position.cross(b.i.velocity) + b.j.position.cross(b.j.velocity)) +
                        b.i.angular_momentum + b.j.angular_momentum);
        };
        const Vec3 p = momentum();
        const Vec3 l = angular();
        PointHistory history;
        run_collision(b, 1e-6, [&](const PairState& pair, double dt) {
            return collide(sphere, sphere, Call{pair, law, dt, memory_of(history)});
        });
        EXPECT_LT((momentum() - p).norm(), 1e-13 * mass);
        EXPECT_LT((angular() - l).norm(), 1e-12 * l.norm());
    }
}

TEST(SphereCollision, SwappingThePairFlipsSignsOnly) {
    const Sphere sphere{3e-3};
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        TwoBodies b = oblique_pair(seed);
        TwoBodies swapped;
        swapped.i = b.j;
        swapped.j = b.i;
        PointHistory h1;
        PointHistory h2;
        for (int k = 0; k < 200; ++k) {
            b.step(1e-6, [&](const PairState& pair, double dt) {
                return collide(sphere, sphere, Call{pair, law, dt, memory_of(h1)});
            });
            swapped.step(1e-6, [&](const PairState& pair, double dt) {
                return collide(sphere, sphere, Call{pair, law, dt, memory_of(h2)});
            });
        }
        EXPECT_LT((b.i.velocity - swapped.j.velocity).norm(), 1e-12);
        EXPECT_LT((b.i.angular_momentum - swapped.j.angular_momentum).norm(),
                  1e-10 * b.i.angular_momentum.norm());
    }
}

/// Largest deviation of kinetic + elastic + dissipated energy from its start, relative.
double ledger_error(std::uint64_t seed, double dt, const ContactLaw& law) {
    const Sphere sphere{3e-3};
    TwoBodies b = oblique_pair(seed);
    const double start = b.kinetic_energy();
    double worst = 0.0;
    PointHistory history;
    run_collision(b, dt, [&](const PairState& pair, double h) {
        return collide(sphere, sphere, Call{pair, law, h, memory_of(history)});
    });
    worst = std::max(worst, std::abs(b.mechanical_energy() + b.dissipated - start));
    return worst / start;
}

TEST(SphereCollision, EnergyLedgerClosesAsTheStepShrinks) {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const double coarse = ledger_error(seed, 1e-6, law);
        const double fine = ledger_error(seed, 1e-7, law);
        EXPECT_LT(coarse, 2e-4);
        EXPECT_LT(fine, 2.5e-5);
    }
}

TEST(SphereCollision, WithoutDissipationTheEnergyIsKeptToSecondOrder) {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        EXPECT_LT(ledger_error(seed, 1e-6, law), 2e-6);
    }
}

}  // namespace
}  // namespace dem::test
