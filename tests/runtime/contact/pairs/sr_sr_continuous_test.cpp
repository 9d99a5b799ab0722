// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_sr_continuous.hpp"

#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

PairState random_pair(const SolidBody& a, const SolidBody& b, Random& random) {
    PairState pair;
    const std::array<const SolidBody*, 2> solids{&a, &b};
    const std::array<BodyState*, 2> states{&pair.i, &pair.j};
    for (std::size_t k = 0; k < 2; ++k) {
        states[k]->orientation = random.orientation();
        states[k]->velocity = 0.1 * random.direction();
        states[k]->angular_velocity = 10.0 * random.direction();
        states[k]->inverse_inertia = solids[k]->inverse(1200.0);
    }
    pair.displacement = random.uniform(5e-3, 14e-3) * random.direction();
    return pair;
}

ContactLaw rough_law() {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    return law;
}

PairState moved(PairState pair, double dt) {
    pair.displacement += dt * (pair.j.velocity - pair.i.velocity);
    for (BodyState* b : {&pair.i, &pair.j})
        b->orientation = Quat(
            Eigen::AngleAxisd(dt * b->angular_velocity.norm(), b->angular_velocity.normalized()) *
            b->orientation);
    return pair;
}

bool same_bits(const PairContact& a, const PairContact& b) {
    return a.force == b.force && a.torque_i == b.torque_i && a.torque_j == b.torque_j &&
           a.elastic_energy == b.elastic_energy && a.dissipated_energy == b.dissipated_energy;
}

// Kernel contract 2: with the cache kept, thrown away each step or filled with nonsense, and calls
// skipped while the proven gap lasts, the same bits come out.
TEST(SrSrContinuous, TheMissCacheNeverChangesABit) {
    const std::vector<SolidBody> all{candy(), tablet(), cylinder(4e-3, 6e-3)};
    const ContactLaw law = rough_law();
    Random random(71, 1);
    int touched = 0;
    for (int k = 0; k < 300; ++k) {
        const SolidBody& a = all[random.next() % all.size()];
        const SolidBody& b = all[random.next() % all.size()];
        PairState pair = random_pair(a, b, random);
        pair.i.velocity += 0.5 * pair.displacement.normalized();
        PointHistory kept_history;
        PointHistory fresh_history;
        PointHistory wild_history;
        PointHistory lazy_history;
        MissCache kept;
        MissCache lazy;
        double quiet = 0.0;
        for (int step = 0; step < 100; ++step) {
            const double dt = 5e-5;
            pair = moved(pair, dt);
            MissCache fresh;
            MissCache wild{random.direction(), -1.0};
            const PairContact c =
                collide(a.shape, b.shape, Call{pair, law, dt, Memory{kept_history, kept}});
            EXPECT_TRUE(same_bits(
                c, collide(a.shape, b.shape, Call{pair, law, dt, Memory{fresh_history, fresh}})));
            EXPECT_TRUE(same_bits(
                c, collide(a.shape, b.shape, Call{pair, law, dt, Memory{wild_history, wild}})));
            quiet -= dt * ((pair.j.velocity - pair.i.velocity).norm() +
                           10.0 * (a.shape.bounding_radius + b.shape.bounding_radius));
            PairContact skipped;
            if (quiet <= 0.0) {
                skipped =
                    collide(a.shape, b.shape, Call{pair, law, dt, Memory{lazy_history, lazy}});
                quiet = skipped.touches() ? 0.0 : lazy.gap;
            }
            EXPECT_TRUE(same_bits(c, skipped));
            touched += c.touches() ? 1 : 0;
            if (c.overlap > 5e-4) break;
        }
    }
    EXPECT_GT(touched, 500);
}

// A direction that is not quite a unit vector proves misses that are none: flats have support
// points from centers thousands of times the size away, and each step made its error larger.
TEST(SrSrContinuous, ADirectionThatProvesAMissKeepsItsLength) {
    const SolidBody body = cylinder(4e-3, 6e-3);
    Random random(77, 1);
    PairState pair = random_pair(body, body, random);
    pair.j.orientation = pair.i.orientation;
    pair.displacement = 6.01e-3 * body_axis(pair.i.orientation);
    PointHistory history;
    MissCache miss;
    for (int step = 0; step < 3000; ++step) {
        pair.j.orientation =
            (rotation(1e-4 * random.direction()) * pair.i.orientation).normalized();
        const PairContact c =
            collide(body.shape, body.shape, Call{pair, rough_law(), 1e-6, Memory{history, miss}});
        ASSERT_FALSE(c.touches());
        ASSERT_NEAR(Vec3(miss.axis).norm(), 1.0, 1e-14) << "step " << step;
    }
}

TEST(SrSrContinuous, SwappingThePairFlipsSignsOnly) {
    const std::vector<SolidBody> all{candy(), tablet(), cylinder(4e-3, 6e-3)};
    const ContactLaw law = rough_law();
    Random random(72, 1);
    int touched = 0;
    for (int k = 0; k < 4000; ++k) {
        const SolidBody& a = all[random.next() % all.size()];
        const SolidBody& b = all[random.next() % all.size()];
        const PairState pair = random_pair(a, b, random);
        const PairState swapped{-pair.displacement, pair.j, pair.i};
        PointHistory h1;
        PointHistory h2;
        MissCache m1;
        MissCache m2;
        const PairContact c = collide(a.shape, b.shape, Call{pair, law, 1e-6, Memory{h1, m1}});
        const PairContact s = collide(b.shape, a.shape, Call{swapped, law, 1e-6, Memory{h2, m2}});
        // Deep overlaps have several local minima; contacts are shallow.
        if (c.overlap > 2e-4 || s.overlap > 2e-4) continue;
        ASSERT_EQ(c.touches(), s.touches());
        if (!c.touches()) continue;
        ++touched;
        EXPECT_NEAR(c.overlap, s.overlap, 1e-13);
        EXPECT_LT((c.force + s.force).norm(), 1e-6 * c.force.norm());
        EXPECT_LT((c.torque_i - s.torque_j).norm(), 1e-6 * 5e-3 * c.force.norm());
    }
    EXPECT_GT(touched, 20);
}

TEST(SrSrContinuous, ARigidMotionOfThePairTurnsTheForceWithIt) {
    const SolidBody body = tablet();
    const ContactLaw law = rough_law();
    Random random(73, 1);
    for (int k = 0; k < 500; ++k) {
        PairState pair = random_pair(body, body, random);
        pair.displacement *= 0.7;
        const Quat turn = random.orientation();
        PairState turned = pair;
        turned.displacement = turn * pair.displacement;
        for (BodyState* b : {&turned.i, &turned.j}) {
            b->orientation = turn * b->orientation;
            b->velocity = turn * b->velocity;
            b->angular_velocity = turn * b->angular_velocity;
        }
        PointHistory h1;
        PointHistory h2;
        MissCache m1;
        MissCache m2;
        const PairContact c =
            collide(body.shape, body.shape, Call{pair, law, 1e-6, Memory{h1, m1}});
        const PairContact t =
            collide(body.shape, body.shape, Call{turned, law, 1e-6, Memory{h2, m2}});
        if (!c.touches() || c.overlap > 5e-4) continue;
        EXPECT_LT((turn * c.force - t.force).norm(), 1e-7 * c.force.norm());
    }
}

TEST(SrSrContinuous, ASphereIsTheSameAsASurfaceOfRevolution) {
    const Sphere sphere{3e-3};
    const SolidBody body = round_body(3e-3);
    const ContactLaw law = rough_law();
    Random random(74, 1);
    for (int k = 0; k < 200; ++k) {
        PairState pair = random_pair(body, body, random);
        pair.displacement = random.uniform(5.95e-3, 6.02e-3) * random.direction();
        PointHistory h1;
        const PairContact expected = collide(sphere, sphere, Call{pair, law, 1e-6, memory_of(h1)});
        const auto compare = [&](const PairContact& c) {
            ASSERT_EQ(c.touches(), expected.touches());
            EXPECT_NEAR(c.overlap, expected.overlap, 1e-16);
            EXPECT_LE((c.force - expected.force).norm(), 1e-9 * expected.force.norm());
        };
        PointHistory h2;
        MissCache miss;
        compare(collide(body.shape, body.shape, Call{pair, law, 1e-6, Memory{h2, miss}}));
        h2 = {};
        compare(collide(sphere, body.shape, Call{pair, law, 1e-6, Memory{h2, miss}}));
    }
}

TEST(SrSrContinuous, TheProvenGapIsSafe) {
    const std::vector<SolidBody> all{candy(), tablet(), cylinder(6e-3, 1.5e-3)};
    Random random(75, 1);
    for (int k = 0; k < 2000; ++k) {
        const SolidBody& a = all[random.next() % all.size()];
        const SolidBody& b = all[random.next() % all.size()];
        PairState pair = random_pair(a, b, random);
        PointHistory history;
        MissCache miss;
        if (collide(a.shape, b.shape, Call{pair, rough_law(), 1e-6, Memory{history, miss}})
                .touches())
            continue;
        ASSERT_GE(miss.gap, 0.0);
        pair.displacement += 0.9999 * miss.gap * random.direction();
        MissCache fresh;
        EXPECT_FALSE(
            collide(a.shape, b.shape, Call{pair, rough_law(), 1e-6, Memory{history, fresh}})
                .touches());
    }
}

}  // namespace
}  // namespace dem::test
