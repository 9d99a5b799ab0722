// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/fields/clump_contact.hpp"

#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/clump_clump.hpp"
#include "runtime/contact/pairs/clump_sr.hpp"
#include "runtime/contact/pairs/clump_wall.hpp"
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/memory_of.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <array>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

const ContactLaw& law() {
    static const ContactLaw one = [] {
        ContactLaw options;
        options.friction = 0.4;
        return pair_law({5e7, 0.3}, {5e7, 0.3}, 0.5, options);
    }();
    return one;
}

SrShape convex_candy() {
    SrShape shape = candy(600);
    shape.support = spheroid(6.585e-3, 3.395e-3).shape.support;
    return shape;
}

struct Host {
    PatchHistory history{};
    NearCache cache{};
    ContactScratch scratch = ContactScratch(20000);
    double travel = 0.0;

    PatchCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {history, cache}, travel, {&scratch}};
    }
};

BodyState random_state(Random& random) {
    return {random.orientation(),
            0.1 * random.direction(),
            5.0 * random.direction(),
            {1e3, Vec3(2e8, 2e8, 1.5e8)}};
}

using Kernel = std::function<PairContact(const PairState&, Host&)>;
template <class A, class B>
Kernel kernel(const A& a, const B& b) {
    return [&a, &b](const PairState& pair, Host& host) {
        return collide(a, b, host.call(pair, law(), 1e-6));
    };
}

bool same_bits(const PairContact& a, const PairContact& b) {
    return a.force == b.force && a.torque_i == b.torque_i && a.torque_j == b.torque_j &&
           a.overlap == b.overlap && a.points == b.points && a.elastic_energy == b.elastic_energy &&
           a.dissipated_energy == b.dissipated_energy;
}

/// Lets j wander about `reach` from i and turn, and compares every contact with that of a pair that
/// remembers its history alone. Returns how many contacts there were.
int wander(const Kernel& collide_pair, double reach, double bounding_sum, std::uint64_t seed) {
    Random random(seed, 0);
    int contacts = 0;
    for (int start = 0; start < 10; ++start) {
        Host host;
        PairState pair{{}, random_state(random), random_state(random)};
        pair.displacement = random.uniform(0.75, 1.05) * reach * random.direction();
        for (int step = 0; step < 25; ++step) {
            const double length = bounding_sum * std::pow(10.0, random.uniform(-5.0, -2.0));
            const Vec3 move = length * random.direction();
            pair.displacement += move;
            const double turn = length / bounding_sum;
            const Quat q(Eigen::AngleAxisd(turn, random.direction()));
            pair.j.orientation = q * pair.j.orientation;
            host.travel += 1.001 * length + 1.001 * turn * bounding_sum;

            Host blank;
            blank.history = host.history;
            const PairContact expected = collide_pair(pair, blank);
            if (host.travel < host.cache.clear_until) {
                EXPECT_FALSE(expected.touches());
                continue;
            }
            EXPECT_TRUE(same_bits(collide_pair(pair, host), expected));
            contacts += expected.touches() ? 1 : 0;
        }
    }
    return contacts;
}

TEST(ClumpContact, TheListNeverChangesABitOfAnyPairOfKinds) {
    const Clump a = candy_clump(60);
    const Clump many = candy_clump(300);
    const Clump dumbbell = dumbbell_clump(4e-3, 1.5e-3);
    const Sphere sphere{4e-3};
    const SrShape convex = convex_candy();
    const SrShape hollow = peanut(600);
    const double r = 6.6e-3;
    EXPECT_GT(wander(kernel(a, a), 1.6 * r, 2.0 * r, 1), 20);
    EXPECT_GT(wander(kernel(many, a), 1.6 * r, 2.0 * r, 2), 20);
    EXPECT_GT(wander(kernel(many, many), 1.6 * r, 2.0 * r, 3), 20);
    EXPECT_GT(wander(kernel(sphere, a), 1.4 * r, 1.6 * r, 4), 20);
    EXPECT_GT(wander(kernel(sphere, dumbbell), 1.4 * r, 1.6 * r, 5), 20);
    EXPECT_GT(wander(kernel(a, convex), 1.6 * r, 2.0 * r, 6), 20);
    EXPECT_GT(wander(kernel(dumbbell, convex), 1.6 * r, 2.0 * r, 7), 20);
    ASSERT_GT(a.largest_radius, hollow.sdf.margin);
    ASSERT_LT(dumbbell.largest_radius, hollow.sdf.margin);
    EXPECT_GT(wander(kernel(a, hollow), 1.6 * r, 2.0 * r, 8), 20);
    EXPECT_GT(wander(kernel(dumbbell, hollow), 1.2 * r, 2.0 * r, 9), 20);
    const PlaneWall plane, disc{20e-3};
    const CylinderWall tube{20e-3, 30e-3}, rod{8e-3, 10e-3, false};
    EXPECT_GT(wander(kernel(a, plane), 1.0 * r, 1.0 * r, 10), 20);
    EXPECT_GT(wander(kernel(a, disc), 1.0 * r, 1.0 * r, 11), 20);
    EXPECT_GT(wander(kernel(many, tube), 20e-3, 3.0 * r, 12), 20);
    EXPECT_GT(wander(kernel(dumbbell, rod), 10e-3, 3.0 * r, 13), 20);
}

TEST(ClumpContact, TouchesInThePairsOfSpheresThatAWalkOverAllPairsFinds) {
    const Clump a = candy_clump(60);
    const Clump b = candy_clump(300);
    Random random(2, 0);
    int contacts = 0;
    for (int trial = 0; trial < 300; ++trial) {
        PairState pair{{}, random_state(random), random_state(random)};
        pair.displacement = random.uniform(7e-3, 12e-3) * random.direction();
        std::vector<ContactPoint> points;
        double deepest = 0.0;
        double radius = 0.0;
        for (std::uint32_t k = 0; k < a.spheres.size(); ++k) {
            for (std::uint32_t m = 0; m < b.spheres.size(); ++m) {
                const Vec3 x = pair.i.orientation * a.spheres[k].center();
                const Vec3 y = pair.displacement + pair.j.orientation * b.spheres[m].center();
                const double r = a.spheres[k].radius;
                const double s = b.spheres[m].radius;
                const double overlap = r + s - (x - y).norm();
                if (overlap <= 0.0) continue;
                const Vec3 n = (x - y).normalized();
                points.push_back({x - (r - 0.5 * overlap) * n, n, overlap, 1000ULL * k + m});
                if (overlap > deepest) radius = r * s / (r + s);
                deepest = std::max(deepest, overlap);
            }
        }
        Host host, brute;
        const PairContact found = collide(a, b, host.call(pair, law(), 1e-6));
        ASSERT_EQ(found.points, points.size());
        if (points.empty()) continue;
        ++contacts;
        const PairContact expected =
            contact_force(points, radius, pair, law(), 1e-6, brute.history);
        EXPECT_NEAR((found.force - expected.force).norm(), 0.0, 1e-9 * expected.force.norm());
        EXPECT_NEAR((found.torque_j - expected.torque_j).norm(), 0.0,
                    1e-9 * 0.01 * expected.force.norm());
    }
    EXPECT_GT(contacts, 50);
}

TEST(ClumpContact, SwappingThePairNegatesTheForce) {
    const Clump a = candy_clump(60);
    Random random(3, 0);
    const auto compare = [&](const auto& one, const auto& other) {
        int contacts = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const PairState pair{random.uniform(4e-3, 12e-3) * random.direction(),
                                 random_state(random), random_state(random)};
            const PairState swapped{-pair.displacement, pair.j, pair.i};
            Host host, back;
            const PairContact c = collide(one, other, host.call(pair, law(), 1e-6));
            const PairContact d = collide(other, one, back.call(swapped, law(), 1e-6));
            ASSERT_EQ(c.points, d.points);
            EXPECT_NEAR((c.force + d.force).norm(), 0.0, 1e-7 * c.force.norm());
            EXPECT_NEAR((c.torque_i - d.torque_j).norm(), 0.0, 1e-9 * c.force.norm());
            contacts += c.touches() ? 1 : 0;
        }
        EXPECT_GT(contacts, 30);
    };
    compare(a, candy_clump(300));
    compare(a, dumbbell_clump(4e-3, 1.5e-3));
}

/// The force on the one-sphere clump and on the sphere, over random poses.
template <class Other, class Reference>
void expect_same_force(const char* name, const Other& other, double nearest, double farthest,
                       double tolerance, const Reference& reference) {
    SCOPED_TRACE(name);
    const double radius = 2e-3;
    const Clump clump = make_clump({{0.0, 0.0, 0.0, radius, 1.0}});
    Random random(4, 0);
    int contacts = 0;
    for (int trial = 0; trial < 300; ++trial) {
        PairState pair{random.uniform(nearest, farthest) * random.direction(), random_state(random),
                       random_state(random)};
        pair.j.inverse_inertia = {};  // as a wall has it
        Host host;
        const PairContact c = collide(clump, other, host.call(pair, law(), 1e-6));
        const PairContact s = reference(Sphere{radius}, pair);
        ASSERT_EQ(c.touches(), s.touches()) << trial;
        EXPECT_NEAR((c.force - s.force).norm(), 0.0, tolerance * s.force.norm());
        EXPECT_NEAR((c.torque_i - s.torque_i).norm(), 0.0, tolerance * radius * s.force.norm());
        contacts += c.touches() ? 1 : 0;
    }
    EXPECT_GT(contacts, 30);
}

TEST(ClumpContact, AClumpOfOneSphereIsThatSphere) {
    const auto closed_form = [](const auto& other) {
        return [&other](const Sphere& sphere, const PairState& pair) {
            PointHistory history;
            return collide(sphere, other, Call{pair, law(), 1e-6, memory_of(history)});
        };
    };
    const PlaneWall plane, disc{5e-3};
    const CylinderWall tube{8e-3, 12e-3}, rod{3e-3, 4e-3, false};
    expect_same_force("plane", plane, 0.0, 6e-3, 1e-10, closed_form(plane));
    expect_same_force("disc", disc, 0.0, 6e-3, 1e-10, closed_form(disc));
    expect_same_force("tube", tube, 5e-3, 8e-3, 1e-10, closed_form(tube));
    expect_same_force("rod", rod, 0.0, 7e-3, 1e-10, closed_form(rod));
    const SrShape hollow = peanut(600);
    expect_same_force("hollow", hollow, 4e-3, 9e-3, 1e-10,
                      [&](const Sphere& sphere, const PairState& pair) {
                          Host host;
                          return collide(sphere, hollow, host.call(pair, law(), 1e-6));
                      });
    const SrShape convex = convex_candy();
    expect_same_force(
        "convex", convex, 4e-3, 9e-3, 1e-7, [&](const Sphere& sphere, const PairState& pair) {
            PointHistory history;
            MissCache miss;
            return collide(sphere, convex, Call{pair, law(), 1e-6, Memory{history, miss}});
        });
}

TEST(ClumpContact, KeepsTheDeepestPointsWhenThereIsNoRoomForAll) {
    const Clump a = candy_clump(300);
    const PairState pair{{0.0, 0.0, 6.7e-3}, {}, {}};
    Host all, few;
    few.scratch.resize(20);
    const PairContact expected = collide(a, a, all.call(pair, law(), 1e-6));
    const PairContact found = collide(a, a, few.call(pair, law(), 1e-6));
    ASSERT_GT(expected.points, 20U);
    EXPECT_EQ(found.points, 20U);
    for (std::size_t k = 1; k < 20; ++k)
        EXPECT_LT(few.scratch[k - 1].feature, few.scratch[k].feature);
    double shallowest = 1.0;
    for (const ContactPoint& p : few.scratch) shallowest = std::min(shallowest, p.overlap);
    int deeper = 0;
    for (std::size_t k = 0; k < expected.points; ++k)
        deeper += all.scratch[k].overlap > shallowest ? 1 : 0;
    EXPECT_LT(deeper, 20);
}

}  // namespace
}  // namespace dem::test
