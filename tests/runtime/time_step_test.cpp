// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/time_step.hpp"

#include "common/error.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/spheres_over_a_floor.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

using scenes::at;
using scenes::spheres_over_a_floor;

constexpr double radius = scenes::small_radius;

TEST(TimeStep, IsAFractionOfTheRayleighTimeForSlowSpheres) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, radius)});
    const double shear = 1e7 / 2.6;
    const double expected = pi * radius / (0.8766 + 0.1631 * 0.3) * std::sqrt(2500.0 / shear);
    EXPECT_NEAR(time_step(scene).rayleigh, expected, 1e-12 * expected);
    EXPECT_DOUBLE_EQ(time_step(scene).value, time_step(scene).critical / 20.0);
    // [SR] Eq. 23 in units of time: twice the size, twice the Hertz time.
    scene.insertions[0].placements[0].velocity.x() = 100.0;
    const double hertz = time_step(scene).hertz;
    EXPECT_DOUBLE_EQ(time_step(scene).critical,
                     std::min({hertz, expected, time_step(scene).motion}));
    Scene twice = spheres_over_a_floor({at(0.0, 0.0, radius)});
    twice.insertions[0].placements[0].velocity.x() = 100.0;
    twice.shapes[0] = scenes::sphere(2.0 * radius);
    twice.kinds[0].mass *= 8.0;
    EXPECT_NEAR(time_step(twice).hertz / hertz, 2.0, 1e-3);
}

TEST(TimeStep, NothingTravelsFurtherThanItsSize) {
    const auto critical = [](const auto& change) {
        Scene scene = spheres_over_a_floor({at(0.0, 0.0, radius)});
        change(scene);
        return time_step(scene).critical;
    };
    const double usual = critical([](Scene&) {});
    const double shaken = critical([](Scene& scene) {
        scene.walls[0].motion.pieces = {
            {.kind = MotionPiece::Kind::oscillate, .amplitude = 1e-6, .frequency = 1e5}};
    });
    EXPECT_DOUBLE_EQ(shaken, 0.5e-5);
    const double lifted = critical([](Scene& scene) {
        scene.walls[0].motion.pieces = {
            {.kind = MotionPiece::Kind::translate, .velocity = {0.0, 0.0, 1e6}}};
    });
    EXPECT_NEAR(lifted, radius / 1e6, 1e-3 * lifted);
    const double spinning = critical([](Scene& scene) {
        scene.insertions[0].placements[0].angular_velocity = {0.0, 0.0, 1e8};
    });
    EXPECT_NEAR(spinning, 1e-8, 1e-3 * spinning) << "one radian";
    EXPECT_LT(lifted, usual);
}

// A spring s times as stiff swings sqrt(s) times as fast; up to Mindlin's stiffness at a Poisson's
// ratio of zero the step is long enough as it is.
TEST(TimeStep, ShrinksWithTangentialSpringsThatAreStifferThanMindlins) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, radius)});
    const double usual = time_step(scene).rayleigh;
    ContactLaw law = scene.laws.at(0, 0);
    ASSERT_EQ(law.tangential, ContactLaw::Tangential::mindlin);
    law.tangential = ContactLaw::Tangential::ratio;
    for (const double ratio : {2.0 / 7.0, 1.5, 150.0}) {
        law.stiffness_ratio = ratio;
        scene.laws.set(0, 0, law);
        EXPECT_NEAR(time_step(scene).rayleigh, ratio > 1.5 ? 0.1 * usual : usual, 1e-12 * usual);
    }
}

TEST(TimeStep, OfTheLinearLawMakesNoEnergyHoweverStrongTheDashpot) {
    for (const double e : {1e-30, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.8}) {
        Scene scene = spheres_over_a_floor({at(0.0, 0.0, 1.0001 * radius)});
        scene.insertions[0].placements[0].velocity.z() = -0.1;
        const ContactLaw law = linear_law(1e5, e, 1.0, scene.laws.at(0, 0));
        scene.laws.set(0, 0, law);
        const TimeStep limit = time_step(scene);
        const double contact = law.contact_time * std::sqrt(scene.kinds[0].mass / 1e5);
        if (e >= 0.5)
            EXPECT_DOUBLE_EQ(limit.linear, 0.4 * std::sqrt(0.5) * contact);
        else
            EXPECT_LT(limit.linear, 0.4 * std::sqrt(0.5) * contact);
        const double before = 0.5 * scene.kinds[0].mass * square(0.1);
        Simulation simulation(std::move(scene), 0.99 * std::min(limit.linear, limit.motion));
        for (int step = 0; step < 200; ++step) simulation.step();
        const Energies after = energies(simulation);
        EXPECT_LT(after.translational, before) << e;
    }
}

TEST(TimeStep, AboveTheCriticalOneIsRefusedUnlessForced) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, radius)});
    scene.run.time_step = 1.01 * time_step(scene).critical;
    EXPECT_THROW(time_step(scene), Error);
    scene.run.time_step_force = true;
    EXPECT_EQ(time_step(scene).value, *scene.run.time_step);
}

TEST(TimeStep, MustFitTheRun) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, radius)});
    EXPECT_EQ(step_count(scene.run, scene.run.end_time / 1000.0, "here"), 1000);
    EXPECT_EQ(step_count(scene.run, scene.run.end_time / 999.5, "here"), 1000);
    EXPECT_THROW(step_count(scene.run, 1e-300, "here"), Error);
    EXPECT_THROW(step_count(scene.run, 0.0, "here"), Error);
    scene.run.end_time = 1e-7;
    EXPECT_THROW(time_step(scene), Error) << "an automatic step longer than the run";
}

}  // namespace
}  // namespace dem::runtime
