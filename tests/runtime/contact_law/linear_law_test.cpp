// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/contact/sphere_sphere.hpp"
#include "runtime/contact/sphere_wall.hpp"
#include "runtime/contact_law/hertz_mindlin.hpp"
#include "runtime/contact_law/pair_law.hpp"
#include "tests/physics/two_bodies.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::test {
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
            return collide(Sphere{radius}, Sphere{radius}, pair, law, h, history);
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

// Sec. "Without slip" of docs/contact.md.
TEST(LinearLaw, ForceAndPushWithoutSlipAreTheGradientOfTheEnergy) {
    const double k_n = 1e4;
    const double k_t = 3e3;
    const auto at = [&](double overlap, double stretch) {
        Vec3 lead = stretch * Vec3::UnitY();
        return hertz::sticking_force(k_t, 0.0, hertz::no_slip * k_n * overlap, hertz::no_slip * k_n,
                                     Vec3::Zero(), 1e-6, lead);
    };
    const double overlap = 1e-6;
    const double reach = hertz::no_slip * k_n * overlap / k_t;  // beyond, the spring lets go
    const double h = 1e-6 * overlap;
    for (const double stretch :
         {0.3 * reach, 0.999 * reach, 1.001 * reach, 2.0 * reach, 1e3 * reach}) {
        const hertz::TangentialForce t = at(overlap, stretch);
        const double by_stretch =
            (at(overlap, stretch + h).elastic - at(overlap, stretch - h).elastic) / (2.0 * h);
        const double by_overlap =
            (at(overlap + h, stretch).elastic - at(overlap - h, stretch).elastic) / (2.0 * h);
        EXPECT_NEAR(-t.force.y(), by_stretch, 1e-4 * k_t * reach);
        EXPECT_NEAR(t.push, by_overlap, 1e-4 * k_t * reach);
    }
    EXPECT_EQ(at(0.0, 1e-5).elastic, 0.0);
    EXPECT_EQ(at(overlap, 0.9 * reach).push, 0.0);
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
