// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "tests/physics/convex_combinations.hpp"
#include "tests/physics/two_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

// Binary collisions of convex shapes without dissipation, as a table:
//
//     convex_collisions features|centroid [collisions]
//
// For each of the eight combinations of [GC] Sec. 6.2: relative change of the kinetic energy of
// frictionless collisions, random and nearly parallel, at a hundredth and a thousandth of the
// contact time; and the paper's own measure, what the tangential springs hold in the last step of a
// contact, with e_n = e_t = 1 and a friction that never slips, or that of [GC] Table 7.

namespace dem::test {

using namespace runtime;

namespace {

constexpr double density = 1000.0;  // [kg/m^3]
constexpr double size = 0.01;       // [m]
constexpr double speed = 0.2;       // of approach, or standard deviation [m/s]
constexpr double stiffness = 1e4;   // k_n [N/m]

InverseInertia inertia_of(const ConvexSolid& solid) {
    const MassProperties& m = solid.mass_properties;
    InverseInertia inverse =
        inverse_inertia(density * m.volume, density * m.principal_moments_per_density);
    const double mean = density * m.principal_moments_per_density.mean();
    inverse.surface = solid.mean_squared_surface_distance / mean;
    return inverse;
}

/// Three normal deviates (Box and Muller).
Vec3 gaussian(Random& random) {
    const auto deviate = [&] {
        return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) *
               std::cos(2.0 * pi * random.uniform());
    };
    const double x = deviate();
    const double y = deviate();
    return {x, y, deviate()};
}

enum class Approach { random, parallel };

/// Turned any way, or a face towards the other body but for a tilt of 3e-8 to 0.03.
Quat attitude(const ConvexShape& shape, const Vec3& to, Approach approach, Random& random) {
    if (approach == Approach::random) return random.orientation();
    const Vec3 face = shape.planes.empty() ? Vec3::UnitZ() : shape.planes[0].normal;
    const Quat spun = orientation_towards(to) *
                      rotation(Vec3(0.0, 0.0, random.uniform(0.0, 2.0 * pi))) *
                      orientation_towards(face).conjugate();
    const double angle = 0.03 * std::pow(10.0, random.uniform(-6.0, 0.0));
    return rotation(angle * random.direction()) * spun;
}

/// Two bodies about to meet.
TwoBodies start(const Combination& pair, Approach approach, Random& random) {
    TwoBodies bodies;
    bodies.i.inverse = inertia_of(pair.a);
    bodies.j.inverse = inertia_of(pair.b);
    if (approach == Approach::random) {
        for (Body* b : {&bodies.i, &bodies.j}) {
            b->velocity = speed / std::sqrt(6.0) * gaussian(random);
            b->angular_momentum =
                speed / size / std::sqrt(3.0) * gaussian(random).cwiseQuotient(b->inverse.moments);
        }
    } else {
        const Vec3 towards = random.direction();
        bodies.i.velocity = 0.5 * speed * towards;
        bodies.j.velocity = -0.5 * speed * towards;
    }
    const Vec3 towards = (bodies.i.velocity - bodies.j.velocity).normalized();
    bodies.i.orientation = attitude(pair.a.shape, towards, approach, random);
    bodies.j.orientation = attitude(pair.b.shape, -towards, approach, random);
    const double far = pair.a.shape.bounding_radius + pair.b.shape.bounding_radius;
    bodies.j.position = far * towards + random.uniform(0.0, 0.4 * size) * towards.unitOrthogonal();
    return bodies;
}

struct Outcome {
    bool touched = false;
    double energy_error = 0.0;  // |E/E_0 - 1|
    double spring_share = 0.0;  // of the tangential springs in the last step of the contact
};

Outcome collision(const Combination& pair, const ContactLaw& law, double dt, Approach approach,
                  Random& random) {
    TwoBodies bodies = start(pair, approach, random);
    ConvexHistory history{};
    PairContact last;
    MissCache miss{};
    ConvexScratch scratch{};
    const double far = pair.a.shape.bounding_radius + pair.b.shape.bounding_radius;
    const double before = bodies.kinetic_energy();
    Outcome outcome;
    for (int step = 0; step < 400'000; ++step) {
        // Apart, the bodies only fly: no farther than they are certain not to meet.
        const double pace =
            (bodies.i.velocity - bodies.j.velocity).norm() +
            (bodies.i.angular_velocity().norm() + bodies.j.angular_velocity().norm()) * far;
        const double flight = 0.9 * miss.gap / pace;
        const bool flies = !bodies.contact.touches() && flight > dt;
        bodies.step(flies ? flight : dt, [&](const PairState& state, double h) {
            return collide(pair.a.shape, pair.b.shape,
                           CoreCall{state, law, h, {history, miss}, 0.0, {nullptr, &scratch}});
        });
        if (bodies.contact.touches()) {
            outcome.touched = true;
            last = bodies.contact;
            continue;
        }
        const Vec3 apart = bodies.j.position - bodies.i.position;
        const bool leaves = apart.dot(bodies.j.velocity - bodies.i.velocity) > 0.0;
        if ((outcome.touched && miss.gap > 1e-3 * size) || (leaves && apart.norm() > 1.1 * far))
            break;
    }
    outcome.energy_error = std::abs(bodies.kinetic_energy() / before - 1.0);
    outcome.spring_share =
        (last.elastic_energy - 0.5 * law.normal_stiffness * square(last.overlap)) / before;
    return outcome;
}

struct Mean {
    double energy_error = 0.0, worst = 0.0, spring_share = 0.0;
};

Mean mean_of(const Combination& pair, const ContactLaw& law, double fraction, Approach approach,
             int wanted) {
    const double mass = 1.0 / (inertia_of(pair.a).mass + inertia_of(pair.b).mass);
    const double dt = pi * std::sqrt(mass / stiffness) / fraction;
    Random random(11, 7);
    Mean mean;
    int count = 0;
    while (count < wanted) {
        const Outcome outcome = collision(pair, law, dt, approach, random);
        if (!outcome.touched) continue;
        ++count;
        mean.energy_error += outcome.energy_error / wanted;
        mean.worst = std::max(mean.worst, outcome.energy_error);
        mean.spring_share += outcome.spring_share / wanted;
    }
    return mean;
}

void print_table(ContactLaw::Method method, int wanted) {
    ContactLaw options;
    options.geometry.method = method;
    const ContactLaw smooth = linear_law(stiffness, 1.0, 1.0, options);
    options.friction = 0.1;
    const ContactLaw slipping = linear_law(stiffness, 1.0, 1.0, options);
    options.friction = 1e9;
    const ContactLaw rough = linear_law(stiffness, 1.0, 1.0, options);
    std::printf("combination,approach,fraction,friction,collisions,mean,worst,spring_share\n");
    for (const Combination& pair : combinations(size)) {
        const auto print = [&](const ContactLaw& law, double fraction, Approach approach) {
            const Mean m = mean_of(pair, law, fraction, approach, wanted);
            std::printf("%s,%s,%g,%g,%d,%.3e,%.3e,%.3e\n", pair.name,
                        approach == Approach::random ? "random" : "parallel", fraction,
                        law.friction, wanted, m.energy_error, m.worst, m.spring_share);
            std::fflush(stdout);
        };
        for (const double fraction : {100.0, 1000.0}) {
            for (const Approach approach : {Approach::random, Approach::parallel})
                print(smooth, fraction, approach);
        }
        print(slipping, 1000.0, Approach::random);
        for (const double fraction : {50.0, 100.0, 1000.0})
            print(rough, fraction, Approach::random);
    }
}

}  // namespace
}  // namespace dem::test

int main(int argc, char** argv) {
    const std::string method = argc > 1 ? argv[1] : "";
    const int collisions = argc > 2 ? std::atoi(argv[2]) : 1000;
    if ((method != "features" && method != "centroid") || collisions < 1) {
        std::fprintf(stderr, "usage: convex_collisions features|centroid [collisions]\n");
        return 2;
    }
    using Method = dem::runtime::ContactLaw::Method;
    dem::test::print_table(method == "centroid" ? Method::centroid : Method::automatic, collisions);
    return 0;
}
