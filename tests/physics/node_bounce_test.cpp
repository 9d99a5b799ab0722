// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

/// [SR] Sec. 4 candies; the moments are those of the enclosing spheroid for any shape: energy and
/// momentum are kept for every symmetric body.
InverseInertia inertia_of(const SrShape& shape) {
    const double mass = 1377.0 * pi / 6.0 * cube(shape.equivalent_diameter);
    const double a2 = square(shape.max_radius);
    const double c2 = square(0.5 * (shape.top_z - shape.bottom_z));
    return inverse_inertia(mass, mass / 5.0 * Vec3(a2 + c2, a2 + c2, 2.0 * a2));
}

ContactLaw elastic_law(ContactLaw options = {}) {
    return pair_law({5e7, 0.29}, {5e7, 0.29}, 1.0, options);
}

/// What the host owns for a pair, and the travel it counts.
struct Host {
    PatchHistory history{};
    NearCache cache{};
    ContactScratch scratch;
    double travel = 0.0;

    explicit Host(std::uint32_t nodes) : scratch(nodes) {}
    PatchCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {history, cache}, travel, {&scratch}};
    }
};

/// Relative change of the kinetic energy of a bounce between two bodies that fly at each other at
/// 0.2 m/s, at random attitudes and off center. Sets `touched`.
template <class Collide>
double energy_error(const SrShape& a, const SrShape& b, Random& random, bool& touched,
                    const Collide& collide_pair) {
    TwoBodies bodies;
    bodies.i.inverse = inertia_of(a);
    bodies.j.inverse = inertia_of(b);
    bodies.i.orientation = random.orientation();
    bodies.j.orientation = random.orientation();
    const Vec3 towards = random.direction();
    const Vec3 across = towards.unitOrthogonal();
    const double far = a.bounding_radius + b.bounding_radius;
    bodies.j.position = 1.001 * far * towards + random.uniform(0.0, 0.3) * far * across;
    bodies.i.velocity = 0.1 * towards;
    bodies.j.velocity = -0.1 * towards;
    // Bring them close without a step: before they touch they fly freely.
    Host host(std::max(a.nodes.count, b.nodes.count));
    const double before = bodies.kinetic_energy();
    const double dt = 1e-6;
    touched = false;
    for (int step = 0; step < 200'000; ++step) {
        const double spin = bodies.i.angular_velocity().norm() * a.bounding_radius +
                            bodies.j.angular_velocity().norm() * b.bounding_radius;
        host.travel += 1.01 * dt * (bodies.i.velocity.norm() + bodies.j.velocity.norm() + spin);
        bodies.step(dt, [&](const PairState& pair, double h) -> PairContact {
            if (host.travel < host.cache.clear_until) return {};
            return collide_pair(pair, h, host);
        });
        touched = touched || bodies.contact.touches();
        const bool parting =
            bodies.pair().displacement.dot(bodies.j.velocity - bodies.i.velocity) > 0;
        if (!bodies.contact.touches() && parting &&
            (touched || bodies.pair().displacement.norm() > far))
            break;
    }
    return std::abs(bodies.kinetic_energy() / before - 1.0);
}

double mean_energy_error(const SrShape& a, const SrShape& b, const ContactLaw& law, int pairs) {
    Random random(11, 0);
    double sum = 0.0;
    for (int n = 0; n < pairs;) {
        bool touched = false;
        const double error =
            energy_error(a, b, random, touched, [&](const PairState& pair, double dt, Host& host) {
                return collide(a, b, host.call(pair, law, dt));
            });
        if (!touched) continue;
        sum += error;
        ++n;
    }
    return sum / pairs;
}

class NodeBounce : public ::testing::Test {
  protected:
    static const SrShape& shape(int which) {
        static const std::array<SrShape, 4> all = {candy(), sharp_tablet(), peanut(),
                                                   red_blood_cell()};
        return all[static_cast<std::size_t>(which)];
    }
};

// docs/contact-nodes.md, "Direction of the force".
TEST_F(NodeBounce, AlongTheGradientOfTheInterpolantEnergyIsKept) {
    for (int a = 0; a < 4; ++a) {
        const double error =
            mean_energy_error(shape(a), shape(a), elastic_law(), a == 0 ? 100 : 40);
        RecordProperty("shape_" + std::to_string(a), std::to_string(error));
        EXPECT_LT(error, a == 1 ? 2e-4 : 3e-5) << "shape " << a;
    }
}

TEST_F(NodeBounce, EveryOtherDirectionOfTheForceChangesTheEnergyMuchMore) {
    const auto error = [](ContactLaw::NodeNormal rule) {
        ContactLaw options;
        options.geometry.node_normal = rule;
        return mean_energy_error(shape(0), shape(0), elastic_law(options), 30);
    };
    using NodeNormal = ContactLaw::NodeNormal;
    EXPECT_LT(error(NodeNormal::gradient), 2e-5);
    EXPECT_GT(error(NodeNormal::normalized), 3e-4);
    EXPECT_GT(error(NodeNormal::vectors), 6e-4);
    EXPECT_GT(error(NodeNormal::averaged), 1e-2);
}

}  // namespace
}  // namespace dem::test
