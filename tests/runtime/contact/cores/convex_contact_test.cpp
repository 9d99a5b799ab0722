// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/pairs/clump_convex.hpp"
#include "tests/runtime/contact/cores/core_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

// The heart of the matter: the force of features, ramps and all, has a potential.
TEST(ConvexContact, ForceAndTorquesAreTheGradientOfTheStoredEnergy) {
    const auto solids = convex_solids();
    for (const double tilt : {pi, 0.03}) {
        for (const auto& [name_a, a] : solids) {
            for (const auto& [name_b, b] : solids) {
                Random random(3, 1);
                int off = 0;
                for (int k = 0; k < 12; ++k) {
                    const Poses p = random_poses(random, tilt);
                    const auto pair_at = [&](double distance) {
                        return PairState{distance * p.direction + p.offset, still(p.i), still(p.j)};
                    };
                    const auto evaluate = [&](const PairState& pair) {
                        return resting_contact(a.shape, b.shape, pair);
                    };
                    const double distance =
                        place_of(0.01, 4.0, [&](double x) { return evaluate(pair_at(x)).overlap; });
                    const PairState pair = pair_at(distance);
                    if (!evaluate(pair).touches()) continue;
                    off += gradient_error(pair, evaluate) > 2e-5 ? 1 : 0;
                }
                // Kinks are met once in some hundred parallel pairs with a round one.
                EXPECT_LE(off, tilt < pi ? 1 : 0) << name_a << " - " << name_b << ' ' << tilt;
            }
        }
    }
}

// Both far points of the end carry, with weights that fade as it is tilted and towards the ends of
// the other body.
TEST(ConvexContact, AnEndThatRocksOnTheSideOfACylinderHasAPotential) {
    const ConvexSolid end = make_cylinder(1.0, 1.0, 0.05);
    const ConvexSolid side = make_cylinder(0.5, 3.0, 0.05);
    Random random(8, 1);
    int several = 0;
    for (int k = 0; k < 200; ++k) {
        const Quat lying = turned(Vec3::UnitY(), 0.5 * pi + random.uniform(-0.06, 0.06));
        const Vec3 beside(random.uniform(-1.5, 1.5), random.uniform(-1.1, 1.1), 0.0);
        const auto pair_at = [&](double height) {
            return PairState{beside + height * Vec3::UnitZ(), still(Quat::Identity()),
                             still(lying)};
        };
        const auto evaluate = [&](const PairState& pair) {
            return resting_contact(end.shape, side.shape, pair);
        };
        const PairState pair =
            pair_at(place_of(0.01, 4.0, [&](double x) { return evaluate(pair_at(x)).overlap; }));
        const PairContact contact = evaluate(pair);
        if (!contact.touches()) continue;
        several += contact.points > 1 ? 1 : 0;
        EXPECT_LT(gradient_error(pair, evaluate), 2e-5) << k;
    }
    EXPECT_GT(several, 50);
}

TEST(ConvexContact, ASphereOfAnyKindTouchesAlike) {
    const ConvexSolid ball = make_convex_sphere(0.5);
    const Sphere sphere{0.4};
    Random random(11, 1);
    for (const auto& [name, solid] : convex_solids()) {
        for (int k = 0; k < 50; ++k) {
            const Vec3 n = random.direction();
            const Quat q = random.orientation();
            const double x = random.uniform(0.3, 1.8);
            const PairState pair{-x * n, still(random.orientation()), still(q)};
            const PairContact as_sphere = resting_contact(sphere, solid.shape, pair);
            const SurfaceDistance d = surface_distance(solid.shape, q.conjugate() * (x * n));
            ASSERT_EQ(as_sphere.touches(), d.distance < 0.4) << name;
            if (!as_sphere.touches()) continue;
            ASSERT_NEAR(as_sphere.overlap, 0.4 - d.distance, 1e-12) << name;
            const Clump one = make_clump({{0.0, 0.0, 0.0, 0.4, 1.0}});
            PatchHistory history;
            NearCache cache;
            ContactScratch scratch(100);
            history.effective_radius = 0.25;
            const PairContact as_clump =
                collide(one, solid.shape,
                        PatchCall{pair, elastic, 1e-6, {history, cache}, 0.0, {&scratch}});
            ASSERT_NEAR((as_clump.force - as_sphere.force).norm(), 0.0,
                        1e-9 * as_sphere.force.norm());
        }
    }
    const PairContact two =
        resting_contact(ball.shape, ball.shape, {{0.0, 0.0, 0.9}, still({}), still({})});
    EXPECT_NEAR(two.overlap, 0.1, 1e-12);
}

// Cores that overlap: the contact goes on as if they did not.
TEST(ConvexContact, OverlapRisesThroughTheOverlapOfTheCores) {
    for (const auto& [name, solid] : convex_solids()) {
        if (solid.shape.is_strictly_convex()) continue;
        Random random(12, 1);
        for (int k = 0; k < 10; ++k) {
            const Poses p = random_poses(random, k < 5 ? pi : 0.0);
            double last = 0.0;
            double last_x = 0.0;
            for (double x = 2.5; x > 0.1; x -= 1e-3) {
                const PairContact c = resting_contact(solid.shape, solid.shape,
                                                      {x * p.direction, still(p.i), still(p.j)});
                if (last > 0.0) {
                    ASSERT_GT(c.overlap, 0.95 * last) << name << ' ' << x;
                    ASSERT_LT(c.overlap, last + 4.0 * (last_x - x)) << name << ' ' << x;
                    ASSERT_TRUE(c.force.allFinite() && c.torque_i.allFinite());
                }
                last = c.overlap;
                last_x = x;
                if (last > 0.15) break;
            }
            EXPECT_GT(last, 0.0);
        }
    }
}

// What a pair remembers of a miss must not change a bit of the contact that follows.
TEST(ConvexContact, TheMissCacheNeverChangesABit) {
    Random random(13, 1);
    const auto solids = convex_solids();
    for (int k = 0; k < 400; ++k) {
        const ConvexShape& a = solids[static_cast<std::size_t>(k) % solids.size()].second.shape;
        const ConvexShape& b =
            solids[static_cast<std::size_t>(k) / 10 % solids.size()].second.shape;
        const Poses p = random_poses(random, k % 2 == 0 ? pi : 1e-3);
        Host fresh;
        Host used;
        bool touched = false;
        for (double x = 2.6; x > 1.0 && !touched; x -= 0.01) {
            const PairState pair{x * p.direction + p.offset, still(p.i), still(p.j)};
            fresh.miss = {};
            const PairContact c = collide(a, b, fresh.call(pair, elastic, 1e-6));
            const PairContact d = collide(a, b, used.call(pair, elastic, 1e-6));
            ASSERT_EQ(c.touches(), d.touches());
            ASSERT_EQ(c.force, d.force);
            ASSERT_EQ(c.torque_i, d.torque_i);
            touched = c.touches();
            if (!touched && used.miss.gap > 0.0) {
                const Vec3 toward = used.miss.gap * (1.0 - 1e-9) * random.direction();
                PairState nearer = pair;
                nearer.displacement += toward;
                Host other;
                ASSERT_FALSE(collide(a, b, other.call(nearer, elastic, 1e-6)).touches());
            }
        }
    }
}

// Counted when it happens, not again in the same contact.
TEST(ConvexContact, CoresThatOverlapAreCountedOnce) {
    const ConvexSolid cube = make_cuboid(Vec3::Ones(), 0.01);
    const PairState pair{{0.1, 0.0, -0.97}, still(Quat::Identity()), still(Quat::Identity())};
    Host host;
    const auto contact = [&] {
        return collide(cube.shape, cube.shape, host.call(pair, elastic, 1e-6));
    };
    EXPECT_TRUE(contact().cores_met);
    EXPECT_FALSE(contact().cores_met);
}

}  // namespace
}  // namespace dem::test
