// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "shapegen/solids/make_convex.hpp"
#include "tests/physics/contact_of.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// What contacts do to energy, for bodies of every kind.
namespace dem::test {

using namespace runtime;
using namespace shapegen;

namespace {

const Elasticity rubber{5e7, 0.3};
constexpr double density = 1200.0;

struct Solid {
    const char* name;
    double volume, bounding_radius;
    InverseInertia inverse;
    std::function<Contact(const ContactLaw&)> with_its_like, with_a_plane;
};

Solid ball() {
    const Sphere sphere{5e-3};
    return {"sphere",
            4.0 / 3.0 * pi * cube(sphere.radius),
            sphere.radius,
            solid_sphere(density, sphere.radius),
            [=](const ContactLaw& law) { return by_sphere(sphere, sphere, law); },
            [=](const ContactLaw& law) { return by_sphere(sphere, PlaneWall{}, law); }};
}

Solid revolved(const char* name, const SolidBody& body) {
    const SrShape shape = body.shape;
    return {name,
            body.volume,
            shape.bounding_radius,
            body.inverse(density),
            [=](const ContactLaw& law) { return by_support(shape, shape, law); },
            [=](const ContactLaw& law) { return by_support(shape, PlaneWall{}, law); }};
}

Solid clump() {
    const SolidBody body = candy();
    const Clump spheres = candy_clump(60);
    return {"clump",
            body.volume,
            body.shape.bounding_radius,
            body.inverse(density),
            [=](const ContactLaw& law) { return by_points(spheres, spheres, law); },
            [=](const ContactLaw& law) { return by_points(spheres, PlaneWall{}, law); }};
}

Solid convex(const char* name, const ConvexSolid& solid) {
    const MassProperties& m = solid.mass_properties;
    const ConvexShape shape = solid.shape;
    return {name,
            m.volume,
            shape.bounding_radius,
            inverse_inertia(density * m.volume, density * m.principal_moments_per_density),
            [=](const ContactLaw& law) { return by_cores(shape, shape, law); },
            [=](const ContactLaw& law) { return by_cores(shape, PlaneWall{}, law); }};
}

std::vector<Solid> solids() {
    return {ball(), revolved("candy", candy()), clump(),
            convex("cube", make_cuboid(Vec3::Constant(0.01), 1e-4)),
            convex("grain", rounded_hull(random_points(20, {0.005, 0.006, 0.004}, 1), 1e-4))};
}

/// 1/20 of the critical time of runtime/time_step.cpp for collisions at `speed` [m/s].
double automatic_step(const Solid& solid, const ContactLaw& law, double speed) {
    const double radius = 0.5 * std::cbrt(6.0 * solid.volume / pi);
    const double shear = rubber.youngs_modulus / (2.0 * (1.0 + rubber.poissons_ratio));
    const double rayleigh =
        pi * radius / (0.8766 + 0.1631 * rubber.poissons_ratio) * std::sqrt(density / shear);
    const double hertz = 2.8683 * std::pow(square(0.5 / solid.inverse.mass) /
                                               (0.5 * radius * square(law.youngs_modulus) * speed),
                                           0.2);
    return std::min(rayleigh, hertz) / 20.0;
}

/// Bodies that fly at each other, or at a plane, at random attitudes, off center and with spin.
TwoBodies before_a_bounce(const Solid& solid, bool on_plane, double speed, Random& random) {
    TwoBodies b;
    b.i.inverse = solid.inverse;
    b.i.orientation = random.orientation();
    b.i.angular_momentum = 0.5 * speed / solid.bounding_radius / solid.inverse.moments.maxCoeff() *
                           random.uniform() * random.direction();
    if (on_plane) {
        b.i.position.z() = 1.02 * solid.bounding_radius;
        b.i.velocity = {random.uniform(-1.0, 1.0) * speed, 0.0, -0.7 * speed};
        return b;
    }
    b.j.inverse = solid.inverse;
    b.j.orientation = random.orientation();
    const Vec3 towards = random.direction();
    const Vec3 across = towards.unitOrthogonal();
    b.j.position = solid.bounding_radius * (2.02 * towards + random.uniform(0.0, 0.5) * across);
    b.i.velocity = 0.5 * speed * (towards + random.uniform(-0.5, 0.5) * across);
    b.j.velocity = -0.5 * speed * towards;
    return b;
}

struct Bounce {
    bool touched = false;
    double residual = 0.0;  ///< of kinetic energy and what was dissipated, over the energy before
    double gain = 0.0;      ///< of kinetic energy, likewise
};

Bounce bounce(TwoBodies b, double dt, const Contact& contact) {
    const double before = b.kinetic_energy();
    Bounce result;
    int free_steps = 0;
    for (int step = 0; step < 100'000 && free_steps < 4; ++step) {
        b.step(dt, contact);
        result.touched = result.touched || b.contact.touches();
        free_steps = result.touched && !b.contact.touches() ? free_steps + 1 : 0;
    }
    result.gain = b.kinetic_energy() / before - 1.0;
    result.residual = (b.kinetic_energy() + b.dissipated) / before - 1.0;
    return result;
}

// docs/time-loop.md, "Time step": the reason for the divisor of the automatic step.
TEST(AutomaticStep, KeepsTheEnergyOfAnElasticBounceToATenthOfAPercent) {
    constexpr double speed = 1.0;
    for (const Solid& solid : solids()) {
        for (const double friction : {0.0, 0.3, 1.0}) {
            ContactLaw options;
            options.friction = friction;
            const ContactLaw law = pair_law(rubber, rubber, 1.0, options);
            const double dt = automatic_step(solid, law, speed);
            double sum = 0.0;
            int count = 0;
            for (std::uint64_t seed = 0; count < 20; ++seed) {
                Random random(61, seed);
                const bool on_plane = seed % 2 == 1;
                const TwoBodies start = before_a_bounce(solid, on_plane, speed, random);
                const Bounce found = bounce(
                    start, dt, on_plane ? solid.with_a_plane(law) : solid.with_its_like(law));
                if (!found.touched) continue;
                sum += std::abs(found.residual);
                ++count;
            }
            EXPECT_LT(sum / count, 1e-3) << solid.name << ", friction " << friction;
        }
    }
}

// A stiffness that changes gives or takes energy without work: R* drifts in long contacts, and a
// stretched tangential spring stiffens as a contact is pressed. No more comes back than was
// dissipated before.
TEST(ContactEnergy, AnElasticBounceNeverEndsWithMoreThanItBeganWith) {
    constexpr double speed = 1.0;
    for (const double poissons_ratio : {0.0, 0.3, 0.49}) {
        const Elasticity material{5e7, poissons_ratio};
        for (const Solid& solid : solids()) {
            if (std::string(solid.name) == "grain") continue;  // jumps from edge to edge
            for (const double friction : {0.3, 1.0, 5.0}) {
                ContactLaw options;
                options.friction = friction;
                const ContactLaw law = pair_law(material, material, 1.0, options);
                const double dt = 0.1 * automatic_step(solid, law, speed);
                double gain = 0.0;
                for (std::uint64_t seed = 0; seed < 10; ++seed) {
                    Random random(62, seed);
                    const bool on_plane = seed % 2 == 1;
                    const TwoBodies start = before_a_bounce(solid, on_plane, speed, random);
                    gain = std::max(
                        gain, bounce(start, dt,
                                     on_plane ? solid.with_a_plane(law) : solid.with_its_like(law))
                                  .gain);
                }
                EXPECT_LT(gain, 1e-5) << solid.name << ", Poisson's ratio " << poissons_ratio
                                      << ", friction " << friction;
            }
        }
    }
}

struct Spinning {
    double gain = 0.0;    ///< most energy above that at the start, over the kinetic energy then
    double loss = 0.0;    ///< in the end, likewise
    double radius = 0.0;  ///< R* in the end [m]
    double local_radius = 0.0;  ///< R* of the place where the body touches in the end [m]
};

/// A prolate spheroid that spins on a plane about the upright, its long axis `tilt` from lying.
Spinning spin(const ContactLaw& law, double tilt, double rate, double seconds) {
    const SolidBody solid = spheroid(2.5e-3, 5e-3);
    TwoBodies b;
    b.i.inverse = solid.inverse(density);
    b.acceleration = {0.0, 0.0, -9.81};
    b.i.orientation = rotation(Vec3(0.0, 0.5 * pi + tilt, 0.0));
    const Vec3 spin_body = rate * (b.i.orientation.conjugate() * Vec3::UnitZ());
    b.i.angular_momentum = b.i.orientation * spin_body.cwiseQuotient(b.i.inverse.moments);
    const double weight = 9.81 / b.i.inverse.mass;
    const double sunk =
        std::pow(weight / (4.0 / 3.0 * law.youngs_modulus * std::sqrt(2.5e-3)), 2.0 / 3.0);
    const double height = std::hypot(5e-3 * std::sin(tilt), 2.5e-3 * std::cos(tilt));
    b.i.position.z() = height - sunk;
    Host<PointHistory, MissCache> host;
    const auto step = [&] {
        b.step(5e-6, [&](const PairState& pair, double dt) {
            return collide(solid.shape, PlaneWall{}, host.call(pair, law, dt));
        });
    };
    const auto energy = [&] { return b.mechanical_energy() + weight * b.i.position.z(); };
    step();
    const double kinetic = b.kinetic_energy();
    const double before = energy();
    Spinning found;
    for (int k = 0; k < static_cast<int>(seconds / 5e-6); ++k) {
        step();
        found.gain = std::max(found.gain, (energy() - before) / kinetic);
    }
    found.loss = (before - energy()) / kinetic;
    found.radius = host.history.effective_radius;
    Host<PointHistory, MissCache> anew;
    collide(solid.shape, PlaneWall{}, anew.call(b.pair(), law, 0.0));
    found.local_radius = anew.history.effective_radius;
    return found;
}

TEST(ContactEnergy, ASpheroidThatSpinsOnASmoothElasticPlaneGainsNothing) {
    for (const double tilt : {0.1, 0.3, 0.6}) {
        const Spinning found = spin(pair_law(rubber, rubber, 1.0), tilt, 20.0, 1.0);
        // What the integration makes of it: the energy swings by the square of the step.
        EXPECT_LT(found.gain, 1e-7) << tilt;
        EXPECT_LT(found.loss, 2e-6) << tilt;
    }
}

TEST(ContactEnergy, ASpheroidThatSpinsOnASmoothPlaneGainsNothingHoweverLittleItDissipates) {
    for (const double e : {0.999, 0.9, 0.5})
        EXPECT_LT(spin(pair_law(rubber, rubber, e), 0.6, 20.0, 1.0).gain, 1e-5) << e;
}

TEST(ContactEnergy, ARestingContactWithFrictionGetsTheStiffnessOfItsPlace) {
    ContactLaw options;
    options.friction = 0.3;
    const Spinning found = spin(pair_law(rubber, rubber, 0.5, options), 0.6, 0.0, 2.0);
    EXPECT_GT(found.loss, 0.0);
    // R* at the touch is 2.4 mm, where the body lies 3.9; it rocks on for long, and R* lags.
    EXPECT_GT(found.radius, 3.5e-3);
    EXPECT_NEAR(found.radius, found.local_radius, 0.05 * found.local_radius);
}

}  // namespace
}  // namespace dem::test
