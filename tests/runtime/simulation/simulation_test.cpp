// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/simulation.hpp"

#include "common/error.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/measure/at_rest.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/measure/fill_height.hpp"
#include "runtime/measure/measures.hpp"
#include "runtime/measure/solid_fraction.hpp"
#include "runtime/time_step.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

constexpr double radius = 5e-3;

Scene spheres_over_a_floor(std::vector<BodyPlacement> bodies) {
    Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::sphere(radius));
    scene.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitZ()));
    scene.insertions.push_back(scenes::placed(std::move(bodies)));
    return scene;
}

BodyPlacement at(double x, double y, double z) {
    BodyPlacement body;
    body.position = {x, y, z};
    return body;
}

std::string error_of(Simulation& simulation, int steps) {
    try {
        for (int n = 0; n < steps; ++n) simulation.step();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Simulation, FreeFallIsExact) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 1.0)}), 1e-4);
    for (int n = 0; n < 1000; ++n) simulation.step();
    EXPECT_NEAR(simulation.particles().position[0].z(), 1.0 - 0.5 * 9.81 * 0.01, 1e-13);
    EXPECT_NEAR(simulation.particles().velocity[0].z(), -0.981, 1e-13);
}

TEST(Simulation, ARestingSphereCarriesItsWeight) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 1.001 * radius)}), 2e-6);
    for (int n = 0; n < 200000; ++n) simulation.step();
    const double weight = simulation.scene().kinds[0].mass * 9.81;
    EXPECT_NEAR(simulation.particles().force[0].z() / weight, 0.0, 1e-6);
    ASSERT_EQ(contact_count(simulation), 1U);
    EXPECT_EQ(coordination_numbers(simulation), (std::vector<std::uint32_t>{1}));
}

// Kinetic, potential, elastic and dissipated energy, less what moving walls did, stay what was
// inserted: friction, damping, rolling, a tilted wall that moves, a second body.
TEST(Simulation, EnergyLedgerClosesBetterWithSmallerSteps) {
    const auto worst_residual = [](double dt) {
        Scene scene =
            spheres_over_a_floor({at(0.0, 0.0, 3.0 * radius), at(0.3 * radius, 0.0, 5.5 * radius)});
        Wall paddle = scenes::plane({4.0 * radius, 0.0, 0.0}, Vec3(-1.0, 0.0, 0.3).normalized());
        paddle.motion.kind = WallMotion::Kind::translate;
        paddle.motion.velocity = {-0.4, 0.1, 0.0};
        scene.walls.push_back(paddle);
        Simulation simulation(std::move(scene), dt);
        double worst = 0.0;
        while (simulation.time() < 0.06) {
            simulation.step();
            worst = std::max(worst, std::abs(energies(simulation).residual()));
        }
        EXPECT_GT(energies(simulation).dissipated, 0.0);
        EXPECT_NE(energies(simulation).wall_work, 0.0);
        return worst / simulation.inserted_energy();
    };
    const double coarse = worst_residual(4e-6);
    const double fine = worst_residual(1e-6);
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, 0.4 * coarse);
}

// Every pair of kinds, one and many points, slip and stick, while a bed comes to rest.
TEST(Simulation, EnergyLedgerOfASettlingBedClosesAsTheStepShrinks) {
    const auto worst_residual = [](double dt) {
        Scene scene = scenes::one_material({2e7, 1400.0, 0.6, 0.4});
        static const ParticleTemplate candy = scenes::candy(300);
        static const ParticleTemplate peanut = scenes::peanut(300);
        scenes::add_kind(scene, candy);
        scenes::add_kind(scene, peanut);
        scenes::add_kind(scene, scenes::sphere(5e-3));
        std::vector<BodyPlacement> bodies = scenes::column(15, 3, 18e-3, 13.5e-3);
        for (BodyPlacement& body : bodies) body.velocity = {0.3, 0.2, -0.5};
        scene.insertions.push_back(scenes::placed(bodies));
        scenes::add_vessel(scene, 18e-3);
        Simulation simulation(std::move(scene), dt);
        double worst = 0.0;
        while (simulation.time() < 0.1) {
            simulation.step();
            if (simulation.steps() % 100 != 0) continue;
            worst = std::max(worst, std::abs(energies(simulation).residual()));
        }
        EXPECT_GT(energies(simulation).dissipated, 0.2 * simulation.inserted_energy());
        return worst / simulation.inserted_energy();
    };
    const double coarse = worst_residual(2e-5);
    const double fine = worst_residual(5e-6);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_LT(fine, 0.4 * coarse);
}

TEST(Simulation, ABodyThatLeavesIsNamedWithStepAndTime) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, 1.0)});
    scene.run.domain = Aabb{Vec3(-1.0, -1.0, 0.9), Vec3(1.0, 1.0, 2.0)};
    Simulation simulation(std::move(scene), 1e-3);
    const std::string message = error_of(simulation, 1000);
    EXPECT_NE(message.find("step 143, time 0.143 s: particle 0 has left the domain"),
              std::string::npos)
        << message;
}

TEST(Simulation, TooMuchOverlapIsNamedWithBothBodies) {
    Simulation pair(spheres_over_a_floor({at(0.0, 0.0, 1.0), at(0.0, 1.8 * radius, 1.0)}), 1e-6);
    EXPECT_NE(error_of(pair, 1).find("step 1, time 1e-06 s: particle 0 and particle 1 overlap by"),
              std::string::npos);
    Simulation wall(spheres_over_a_floor({at(0.0, 0.0, 0.8 * radius)}), 1e-6);
    EXPECT_NE(error_of(wall, 1).find("particle 0 and wall 'plane' overlap by"), std::string::npos);
}

TEST(Simulation, ANumberThatIsNotOneIsFoundAtOnce) {
    BodyPlacement body = at(0.0, 0.0, 1.0);
    body.velocity.x() = std::numeric_limits<double>::quiet_NaN();
    Simulation simulation(spheres_over_a_floor({body}), 1e-6);
    EXPECT_NE(error_of(simulation, 1).find("step 1"), std::string::npos);
    body = at(0.0, 0.0, 1.0);
    body.angular_velocity.x() = 1e200;
    Simulation spinning(spheres_over_a_floor({body}), 1e-6);
    EXPECT_NE(error_of(spinning, 2).find("the orientation of particle 0 is not a number"),
              std::string::npos);
}

TEST(Simulation, FixedBodiesDoNotFallAndHoldOthers) {
    Scene scene = spheres_over_a_floor({at(0.0, 0.0, 0.5), at(0.0, 0.0, 0.5 + 2.1 * radius)});
    scene.kinds.push_back(scene.kinds[0]);
    scene.kinds[1].inverse_inertia = {};
    scene.insertions[0].placements[0].kind = 1;
    scene.insertions[0].kinds = {0, 1};
    Simulation simulation(std::move(scene), 5e-6);
    for (int n = 0; n < 50000; ++n) simulation.step();
    EXPECT_EQ(simulation.particles().position[0], Vec3(0.0, 0.0, 0.5));
    EXPECT_NEAR(simulation.particles().position[1].z(), 0.5 + 2.0 * radius, 2e-5);
}

TEST(AtRest, IsReachedAfterTheLastBounceAndNotAtTheTopOfAFlight) {
    Simulation simulation(spheres_over_a_floor({at(0.0, 0.0, 4.0 * radius)}), 5e-6);
    AtRest at_rest(simulation.scene());
    double last_touchdown = 0.0;
    while (!at_rest.was_reached() && simulation.time() < 2.0) {
        const bool touched = contact_count(simulation) > 0;
        simulation.step();
        if (!touched && contact_count(simulation) > 0) last_touchdown = simulation.time();
        at_rest.look(simulation);
    }
    EXPECT_TRUE(at_rest.was_reached());
    EXPECT_GT(last_touchdown, 0.1);
    EXPECT_GT(simulation.time(), last_touchdown);
    EXPECT_LT(simulation.time(), 0.6);
}

TEST(FillHeight, OfSpheresOnAFloor) {
    std::vector<BodyPlacement> bodies;
    for (int n = 0; n < 12; ++n) bodies.push_back(at(0.0, 0.02 * n, radius + 1e-3 * n));
    Simulation simulation(spheres_over_a_floor(bodies), 1e-6);
    const FillHeight height = fill_height(simulation.particles(), simulation.scene());
    EXPECT_DOUBLE_EQ(height.highest, 2.0 * radius + 11e-3);
    EXPECT_NEAR(height.top_ten, 2.0 * radius + 6.5e-3, 1e-15);
}

// One sphere in the corner of a box and in a cylinder: the surface seen from above is the upper
// half's, pi r^2 (r + z) less the cap's pi r^3 / 3, over the cross-section.
TEST(FillHeight, OfTheSurfaceIsTheVolumeBelowIt) {
    const double below = pi * square(radius) * (radius + 2.0 / 3.0 * radius);
    Scene box = spheres_over_a_floor({at(radius, radius, radius)});
    box.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitX()));
    box.walls.push_back(scenes::plane(Vec3::Zero(), Vec3::UnitY()));
    box.walls.push_back(scenes::plane({4.0 * radius, 0.0, 0.0}, -Vec3::UnitX()));
    box.walls.push_back(scenes::plane({0.0, 3.0 * radius, 0.0}, -Vec3::UnitY()));
    Scene cylinder = spheres_over_a_floor({at(radius, 0.0, radius)});
    scenes::add_vessel(cylinder, 2.0 * radius);
    for (auto& [scene, area] : {std::pair{&box, 12.0 * square(radius)},
                                std::pair{&cylinder, 4.0 * pi * square(radius)}}) {
        Simulation simulation(*scene, 1e-6);
        simulation.step();
        const FillHeight height = fill_height(simulation.particles(), simulation.scene());
        EXPECT_NEAR(height.surface, below / area, 2e-2 * below / area);
    }
}

// A sphere in the middle of a cylinder of three radii, whose core is one of one radius; and in the
// middle of a box of five radii by six, whose core is one by two.
TEST(SolidFraction, IsThatOfTheWallsNeighborhoodAndOfTheCore) {
    Scene cylinder = spheres_over_a_floor({at(0.0, 0.0, radius)});
    scenes::add_vessel(cylinder, 3.0 * radius);
    Scene box = spheres_over_a_floor({at(0.0, 0.0, radius)});
    scenes::add_box(box, {-2.5 * radius, -3.0 * radius, 0.0}, {2.5 * radius, 3.0 * radius, 1.0});
    struct Case {
        Scene* scene;
        double area, core;
    };
    for (const auto& [scene, area, core] :
         {Case{&cylinder, 9.0 * pi, 2.0 / 3.0}, Case{&box, 30.0, -1.0}}) {
        Simulation simulation(*scene, 1e-6);
        simulation.step();
        const auto vessel = find_vessel(simulation.scene());
        ASSERT_TRUE(vessel);
        const SolidFraction f = solid_fraction(simulation.particles(), simulation.scene(), *vessel,
                                               {0.0, 2.0 * radius});
        const double overall = 4.0 / 3.0 * pi / (2.0 * area);
        EXPECT_NEAR(f.overall, overall, 1e-3);
        EXPECT_NEAR(f.bulk_density, 2500.0 * f.overall, 1e-9 * f.bulk_density);
        const double core_area = core > 0.0 ? pi : 2.0;
        EXPECT_NEAR(f.near_wall * (area - core_area) + f.core * core_area, overall * area, 0.01);
        if (core > 0.0) {
            EXPECT_NEAR(f.core, core, 0.005);
            EXPECT_EQ(f.near_wall, 0.0);
        }
        // The thinnest slice is widest in the middle: pi r^2 of the cross-section.
        const SolidFraction slice = solid_fraction(simulation.particles(), simulation.scene(),
                                                   *vessel, {0.999 * radius, 1.001 * radius});
        EXPECT_NEAR(slice.overall, pi / area, 1e-3);
    }
}

TEST(SolidFraction, DoesNotCountTheAirUpToTheHighestBody) {
    std::vector<BodyPlacement> bodies;  // a full layer and one sphere high above it
    for (int k = 0; k < 9; ++k) {
        bodies.push_back(at(2.001 * radius * (k % 3 - 1), 2.001 * radius * (k / 3 - 1), radius));
    }
    bodies.push_back(at(0.0, 0.0, 20.0 * radius));
    Scene scene = spheres_over_a_floor(bodies);
    scenes::add_box(scene, {-3.1 * radius, -3.1 * radius, 0.0}, {3.1 * radius, 3.1 * radius, 1.0});
    scene.measures = {{"bed", MeasureSettings::Kind::solid_fraction, 0.01}};
    Simulation simulation(scene, 1e-6);
    const double surface = fill_height(simulation.particles(), simulation.scene()).surface;
    const SolidFraction expected = solid_fraction(simulation.particles(), simulation.scene(),
                                                  *find_vessel(simulation.scene()), {0.0, surface});
    EXPECT_EQ(measure_values(simulation, simulation.scene().measures.front()).front(),
              expected.overall);
    EXPECT_GT(expected.overall, 0.3) << "0.06 up to the highest point";
    EXPECT_EQ(measure_columns(simulation.scene()).back(), "bed_bulk_density");
}

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
        scene.walls[0].motion.kind = WallMotion::Kind::oscillate;
        scene.walls[0].motion.amplitude = 1e-6;
        scene.walls[0].motion.frequency = 1e5;
    });
    EXPECT_DOUBLE_EQ(shaken, 0.5e-5);
    const double lifted = critical([](Scene& scene) {
        scene.walls[0].motion.kind = WallMotion::Kind::translate;
        scene.walls[0].motion.velocity = {0.0, 0.0, 1e6};
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
