// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "tests/physics/balls.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

/// Resistance to rolling: balls of every kind that come to rest as the closed forms have it.
namespace dem::test {

using namespace runtime;

namespace {

using Model = RollingResistance::Model;

constexpr double density = 2500.0;
constexpr double radius = 5e-3;
constexpr double gravity = 9.81;
constexpr double rolling = 0.1;
constexpr double dt = 2e-6;

ContactLaw resisting(Model model, bool is_linear) {
    ContactLaw options;
    options.friction = 0.8;
    options.rolling = {model, rolling, 0.3};
    const Elasticity soft{1e7, 0.3};
    return is_linear ? linear_law(5e3, 0.5, 0.5, options) : pair_law(soft, soft, 0.5, options);
}

/// A ball at rest on a plane, pressed in as its weight wants, gravity aslant by `slope` [rad].
TwoBodies on_plane(const ContactLaw& law, double slope) {
    TwoBodies b;
    b.i.inverse = ball(density, radius);
    b.acceleration = {gravity * std::sin(slope), 0.0, -gravity * std::cos(slope)};
    const double load = gravity * std::cos(slope) / b.i.inverse.mass;
    const double overlap =
        law.model == ContactLaw::Model::linear
            ? load / law.normal_stiffness
            : std::pow(0.75 * load / (law.youngs_modulus * std::sqrt(radius)), 2.0 / 3.0);
    b.i.position = {0.0, 0.0, radius - overlap};
    return b;
}

void run(TwoBodies& b, const Contact& contact, double time) {
    for (int k = 0; k < std::lround(time / dt); ++k) b.step(dt, contact);
}

/// A ball of 2000 nodes is a solid with as many corners: it rocks from one to the next.
bool has_corners(const KindOfBall& kind) {
    return std::string(kind.name) == "sr, nodes";
}

TEST(Rolling, ABallOfAnyKindStopsWhereTheConstantMomentStopsIt) {
    for (const KindOfBall& kind : kinds_of_ball) {
        for (const bool is_linear : {false, true}) {
            const std::string what = kind.name + std::string(is_linear ? ", linear" : "");
            const ContactLaw law = resisting(Model::constant, is_linear);
            TwoBodies b = on_plane(law, 0.0);
            const double speed = 0.05;
            b.i.velocity.x() = speed;
            b.i.angular_momentum.y() = speed / radius / b.i.inverse.moments.y();
            const double stop = 0.7 * square(speed) / (rolling * gravity);
            const double deceleration = rolling * gravity * 5.0 / 7.0;
            const Contact contact = kind.on_plane(radius, law);
            run(b, contact, 0.5 * speed / deceleration);
            const double tolerance = has_corners(kind) ? 0.03 : 0.01;
            EXPECT_NEAR(b.i.velocity.x(), 0.5 * speed, tolerance * speed) << what;
            run(b, contact, 1.5 * speed / deceleration);
            EXPECT_NEAR(b.i.position.x(), stop, 2.0 * tolerance * stop) << what;
            EXPECT_LT(b.i.velocity.norm(), 0.1 * tolerance * speed) << what;
        }
    }
}

TEST(Rolling, ABallRestsOnASlopeBelowMuAndRollsAboveIt) {
    for (const Model model : {Model::constant, Model::elastic_plastic}) {
        for (const KindOfBall& kind : kinds_of_ball) {
            const ContactLaw law = resisting(model, false);
            for (const double share : {0.9, 1.1}) {
                const double slope = std::atan(share * rolling);
                TwoBodies b = on_plane(law, slope);
                const Contact contact = kind.on_plane(radius, law);
                std::array<double, 3> x{};
                run(b, contact, 0.2);
                for (double& at : x) {
                    run(b, contact, 0.1);
                    at = b.i.position.x();
                }
                if (share < 1.0) {
                    EXPECT_LT(std::abs(x[2] - x[1]), (has_corners(kind) ? 1e-2 : 1e-6) * radius)
                        << kind.name;
                    continue;
                }
                // However fast the swing before the rolling has let it become.
                const double excess =
                    gravity * (std::sin(slope) - rolling * std::cos(slope)) * 5.0 / 7.0;
                const double found = (x[2] - 2.0 * x[1] + x[0]) / square(0.1);
                const double tolerance = has_corners(kind) ? 0.15 : 0.01;
                EXPECT_NEAR(found, excess, tolerance * excess) << kind.name;
            }
        }
    }
}

TEST(Rolling, TheLedgerBooksWhatRollingTakes) {
    for (const Model model : {Model::constant, Model::elastic_plastic}) {
        for (const KindOfBall& kind : kinds_of_ball) {
            const ContactLaw law = resisting(model, false);
            TwoBodies b = on_plane(law, 0.0);
            b.i.velocity.x() = 0.05;
            b.i.angular_momentum.y() = 0.05 / radius / b.i.inverse.moments.y();
            const Contact contact = kind.on_plane(radius, law);
            const auto total = [&] {
                return b.mechanical_energy() + b.dissipated +
                       gravity / b.i.inverse.mass * b.i.position.z();
            };
            b.step(dt, contact);
            const double kinetic = b.kinetic_energy();
            const double before = total();
            run(b, contact, 0.15);
            EXPECT_LT(b.kinetic_energy(), 1e-3 * kinetic) << kind.name;
            EXPECT_NEAR(total(), before, 2e-3 * kinetic) << kind.name;
        }
    }
}

/// Two balls that roll on each other turn against each other; what turns them both alike is free.
TEST(Rolling, BallsOfAPairAreResistedByTheirRelativeRotationAlone) {
    for (const KindOfBall& kind : kinds_of_ball) {
        ContactLaw law = resisting(Model::elastic_plastic, false);
        law.friction = 0.0;
        for (const bool against : {true, false}) {
            TwoBodies b;
            b.i.inverse = ball(density, radius);
            b.j.inverse = ball(density, radius);
            b.j.position = {0.0, 0.0, 1.999 * radius};
            b.i.angular_momentum.x() = 1.0 / b.i.inverse.moments.x();
            b.j.angular_momentum.x() = (against ? -1.0 : 1.0) / b.i.inverse.moments.x();
            const PairState pair = b.pair();
            ContactLaw free = law;
            free.rolling = {};
            const PairContact without = kind.of_pair(radius, radius, free)(pair, dt);
            const PairContact with = kind.of_pair(radius, radius, law)(pair, dt);
            const Vec3 on_i = with.torque_i - without.torque_i;
            const Vec3 on_j = with.torque_j - without.torque_j;
            const double limit = rolling * 0.5 * radius * without.force.norm();
            EXPECT_LE((on_i + on_j).norm(), 1e-12 * limit) << kind.name;
            if (against) {
                EXPECT_LT(on_i.x(), 0.0) << kind.name;
            } else {
                EXPECT_LE(on_i.norm(), 1e-12 * limit) << kind.name;
            }
        }
    }
}

/// A rod that rolls about its own axis on something near its end: little inertia, a long lever.
TEST(Rolling, ASlenderRodGivesNoMoreThanItHas) {
    const double length = 40e-3;
    const double thickness = 0.4e-3;
    const double mass = density * pi * square(thickness) * length;
    const double across = mass * square(length) / 12.0;
    const Vec3 moments(0.5 * mass * square(thickness), across, across);
    const Vec3 n = Vec3::UnitZ();
    const Vec3 center(0.45 * length, 0.0, -thickness);
    for (const Model model : {Model::constant, Model::elastic_plastic}) {
        for (const double resistance : {0.1, 1.0}) {
            const RollingResistance law{model, resistance, 0.3};
            PairState pair{{0.0, 0.0, -radius}, {}, {}};
            pair.i.inverse_inertia = inverse_inertia(mass, moments);
            RollingHistory history;
            double spin = 100.0;
            const double before = 0.5 * moments.x() * square(spin);
            double dissipated = 0.0;
            double held = 0.0;
            for (int k = 0; k < 20'000; ++k) {
                pair.i.angular_velocity = {spin, 0.0, 0.0};
                ContactEnergy energy;
                const Vec3 moment = rolling_moment(
                    law, {pair, dt, k == 0, n, n, center, 1e3, 0.05, dissipated}, history, energy);
                spin += dt * moment.x() / moments.x();
                dissipated += energy.dissipated;
                held = energy.elastic;
            }
            // To the error of these plain steps, in which the spin falls by up to a fifth.
            EXPECT_LE(dissipated, 1.2 * before) << resistance;
            EXPECT_LT(0.5 * moments.x() * square(spin) + held, 0.01 * before) << resistance;
        }
    }
}

/// The limits of the law: mu_r R* F_n once it rolls, k_r theta before.
TEST(Rolling, TheMomentGrowsWithTheAngleUpToItsLimit) {
    const ContactLaw law = resisting(Model::elastic_plastic, true);
    PairState pair{{0.0, 0.0, 1.99 * radius}, {}, {}};
    pair.i.inverse_inertia = ball(density, radius);
    pair.j.inverse_inertia = ball(density, radius);
    const double force = law.normal_stiffness * 0.01 * radius;
    const double half = 0.5 * 0.995 * radius;  // of two levers, shorter by half the overlap
    const double stiffness = 2.25 * law.normal_stiffness * square(rolling * half);
    PointHistory history;
    pair.i.angular_velocity.y() = 0.2;
    // Sliding turns both alike, the moment turns them against each other.
    NoCache none;
    const auto moment = [&] {
        const PairContact c =
            collide(Sphere{radius}, Sphere{radius}, Call{pair, law, dt, Memory{history, none}});
        return 0.5 * (c.torque_i.y() - c.torque_j.y());
    };
    moment();
    moment();
    // Where nothing turns any more the dashpot is out of it.
    const double angle = 0.2 * 2.0 * dt;
    pair.i.angular_velocity.y() = 0.0;
    EXPECT_NEAR(moment(), -stiffness * angle, 1e-9 * stiffness * angle);
    pair.i.angular_velocity.y() = 200.0;
    for (int k = 0; k < 1000; ++k) moment();
    EXPECT_NEAR(moment(), -rolling * half * force, 1e-9 * force * half);
}

}  // namespace
}  // namespace dem::test
