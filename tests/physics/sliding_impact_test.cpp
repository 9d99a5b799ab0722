// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "tests/physics/balls.hpp"
#include "tests/physics/two_bodies.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

/// Impacts that slide from touch to parting: friction gives mu times the normal impulse, whatever
/// dissipates, and the velocities after follow in closed form (Chung and Ooi 2011, test 5).
namespace dem::test {

using namespace runtime;

namespace {

struct Impulses {
    double normal = 0.0, tangential = 0.0;  ///< on i [N s]
    double ratio() const { return tangential / normal; }
};

/// Runs until the contact is over. The normal is the line of centers, or z on a plane.
Impulses run_impact(TwoBodies& bodies, double dt, const Contact& contact) {
    Impulses sum;
    bool touched = false;
    for (int step = 0; step < 100'000; ++step) {
        bodies.step(dt, contact);
        const bool touches = bodies.contact.touches();
        if (touched && !touches) return sum;
        touched = touched || touches;
        const Vec3 n = bodies.j.inverse.mass > 0.0
                           ? Vec3((bodies.i.position - bodies.j.position).normalized())
                           : Vec3::UnitZ();
        const double along = bodies.contact.force.dot(n);
        sum.normal += along * dt;
        sum.tangential += (bodies.contact.force - along * n).norm() * dt;
    }
    ADD_FAILURE() << "the bodies did not part";
    return sum;
}

constexpr double density = 7850.0;
constexpr double speed = 0.02;  // of approach [m/s]
constexpr double slide = 0.1;   // along the surface, more than 7/2 mu (1 + e) times that
constexpr double friction = 0.4;
const Elasticity steel{2.08e11, 0.3};

ContactLaw rough(double e) {
    ContactLaw options;
    options.friction = friction;
    return pair_law(steel, steel, e, options);
}
/// As stiff as steel at this speed, for a body of about half a kilogram.
ContactLaw rough_linear(double e) {
    ContactLaw options;
    options.friction = friction;
    return linear_law(5e7, e, 0.8, options);
}

/// Contact time over 1000, or less [s].
constexpr double step = 2e-7;

TwoBodies above_a_plane(double radius) {
    TwoBodies b;
    b.i.inverse = ball(density, radius);
    b.i.position = {0.0, 0.0, radius * (1.0 + 1e-12)};
    b.i.velocity = {slide, 0.0, -speed};
    return b;
}

/// j flies at i, slanting.
TwoBodies facing(double radius_i, double radius_j) {
    TwoBodies b;
    b.i.inverse = ball(density, radius_i);
    b.j.inverse = ball(density, radius_j);
    b.j.position = {0.0, 0.0, (radius_i + radius_j) * (1.0 + 1e-12)};
    b.j.velocity = {slide, 0.0, -speed};
    return b;
}

TEST(SlidingImpact, FrictionGivesMuTimesTheNormalImpulseOnAPlane) {
    for (const KindOfBall& kind : kinds_of_ball) {
        for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            for (const ContactLaw& law : {rough(e), rough_linear(e)}) {
                TwoBodies b = above_a_plane(0.025);
                const Impulses sum = run_impact(b, step, kind.on_plane(0.025, law));
                EXPECT_NEAR(sum.ratio(), friction, 1e-3 * friction) << kind.name << ", e " << e;
                // v_t' = v_t - mu (1 + e) v_n, w' = 5/2 mu (1 + e) v_n / r
                const double change = friction * (1.0 + e) * speed;
                EXPECT_NEAR(b.i.velocity.x(), slide - change, 1e-3 * change) << kind.name;
                EXPECT_NEAR(b.i.angular_velocity().y() * 0.025, 2.5 * change, 2.5e-3 * change)
                    << kind.name;
            }
        }
    }
}

TEST(SlidingImpact, FrictionGivesMuTimesTheNormalImpulseBetweenSpheres) {
    for (const KindOfBall& kind : kinds_of_ball) {
        for (const auto& [r_i, r_j] : {std::pair{0.025, 0.025}, {0.025, 0.015}}) {
            for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
                TwoBodies b = facing(r_i, r_j);
                const Impulses sum = run_impact(b, step, kind.of_pair(r_i, r_j, rough(e)));
                EXPECT_NEAR(sum.ratio(), friction, 1e-3 * friction) << kind.name << ", e " << e;
                // Nodes push along the gradient of a field that is exact to 4e-4.
                for (const auto& [body, r] : {std::pair{&b.i, r_i}, {&b.j, r_j}}) {
                    const double spin = 2.5 * sum.tangential * body->inverse.mass / r;
                    EXPECT_NEAR(body->angular_velocity().norm(), spin, 2e-3 * spin)
                        << kind.name << ", e " << e;
                }
            }
        }
    }
}

// The ball of Chung and Ooi's test 5 with a restitution of a half and spin instead of speed.
TEST(SlidingImpact, ASpinningBallLeavesWithCoulombsSpeed) {
    ContactLaw law = rough(0.5);
    TwoBodies b = above_a_plane(0.025);
    b.i.velocity = {0.0, 0.0, -0.2};
    b.i.angular_momentum = Vec3(0.0, 60.0, 0.0).cwiseQuotient(b.i.inverse.moments);
    run_impact(b, 1.2e-7, kinds_of_ball[0].on_plane(0.025, law));
    EXPECT_NEAR(b.i.velocity.x(), 0.12, 2e-5);
}

TEST(SlidingImpact, FrictionKeepsToCoulombWhereTheForceMayNotPull) {
    for (const KindOfBall& kind : kinds_of_ball) {
        for (const double e : {0.3, 0.7}) {
            ContactLaw law = rough(e);
            law.limit_force = true;
            TwoBodies b = above_a_plane(0.025);
            const Impulses sum = run_impact(b, step, kind.on_plane(0.025, law));
            EXPECT_NEAR(sum.ratio(), friction, 1e-3 * friction) << kind.name << ", e " << e;
        }
    }
}

/// A cube on a plane with a face, sunk in by a micrometer, parting, sliding and spinning.
PairContact parting_cube(const ContactLaw& law) {
    TwoBodies b;
    b.i.inverse = inverse_inertia(1.0, Vec3::Constant(1e-4));
    b.i.position = {0.0, 0.0, 0.01 - 1e-6};
    b.i.velocity = {1.0, 0.0, 0.1};
    b.i.angular_momentum = Vec3(0.0, 0.0, 1e-2);
    const Contact contact =
        by_cores(make_cuboid(Vec3::Constant(0.02), 2e-4).shape, PlaneWall{}, law);
    PairContact c;
    for (int k = 0; k < 1000; ++k) c = contact(b.pair(), 1e-6);
    return c;
}

TEST(SlidingImpact, FeaturesSlideAndTwistAgainstTheElasticPartOfTheForce) {
    const PairContact elastic = parting_cube(rough(1.0));
    const PairContact damped = parting_cube(rough(0.3));
    ASSERT_LT(damped.force.z(), 0.5 * elastic.force.z());
    EXPECT_NEAR(-damped.force.x(), friction * elastic.force.z(), 1e-9 * elastic.force.z());
    EXPECT_NEAR(damped.torque_i.z(), elastic.torque_i.z(), 1e-9 * std::abs(elastic.torque_i.z()));
}

}  // namespace
}  // namespace dem::test
