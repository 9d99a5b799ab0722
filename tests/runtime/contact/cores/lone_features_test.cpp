// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/placed_core.hpp"
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

std::vector<ConvexSolid> grains() {
    return {make_cuboid({1.0, 1.4, 0.6}, 0.02), make_cuboid({1.2, 1.0, 0.05}, 0.01),
            rounded_hull(tetrahedron_corners(1.5), 0.03), random_polyhedron(20, 1, 0.02),
            random_polyhedron(6, 2, 0.01)};
}

/// Two of the grains in a random pose, overlapping by up to half of their roundings.
struct TouchingGrains {
    const ConvexShape& a;
    const ConvexShape& b;
    PairState pair;
};
TouchingGrains touching_grains(const std::vector<ConvexSolid>& solids, int k, Random& random) {
    const ConvexShape& a = solids[static_cast<std::size_t>(k) % solids.size()].shape;
    const ConvexShape& b = solids[static_cast<std::size_t>(k) / 5 % solids.size()].shape;
    const double tilt = k % 3 == 0 ? std::pow(10.0, random.uniform(-4.0, 0.0)) : pi;
    const Poses p = random_poses(random, tilt);
    const double wanted = std::pow(10.0, random.uniform(-4.0, -0.3)) * (a.rounding + b.rounding);
    const auto pair_at = [&](double x) {
        return PairState{x * p.direction + p.offset, still(p.i), still(p.j)};
    };
    const double x =
        place_of(wanted, 4.0, [&](double y) { return resting_contact(a, b, pair_at(y)).overlap; });
    return {a, b, pair_at(x)};
}

/// What a contact remembers of its first step.
Host after_first_step(const ConvexShape& a, const ConvexShape& b, const PairState& pair) {
    Host host;
    host.history.effective_radius = 0.25;
    host.history.search.direction = Vec3(pair.displacement.normalized() * -1.0);
    collide(a, b, host.call(pair, elastic, 1e-6));
    return host;
}

// Most contacts of grains are a vertex on a face or an edge across another: found to be alone
// they give, to the bit, what all features give.
TEST(ConvexContact, ALoneFeatureIsAllThereIs) {
    const std::vector<ConvexSolid> solids = grains();
    Random random(12, 4);
    int touching = 0;
    int lone = 0;
    ConvexScratch scratch;
    for (int k = 0; k < 4000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
        const PlacedCore j(b, pair.j.orientation, pair.displacement);
        const CoreDistance found = core_distance(i, j, canonical_start(pair.displacement), 0.0);
        if (found.overlaps || found.distance >= i.rounding + j.rounding) continue;
        const ConvexTouch touch = touch_of(i, j, found);
        FeatureSum alone(pair, touch.point.overlap);
        ++touching;
        LoneFeature found_lone;
        Leash leash;
        if (!add_lone_feature(i, j, touch.near, alone, found_lone, leash)) continue;
        ++lone;
        FeatureSum all(pair, touch.point.overlap);
        add_polyhedra(i, j, touch.near, scratch, all);
        ASSERT_EQ(alone.count(), all.count()) << k;
        ASSERT_EQ(alone.power(), all.power()) << k;
        ASSERT_EQ(alone.direction().torque_i, all.direction().torque_i) << k;
        ASSERT_EQ(alone.of_weights().torque_j, all.of_weights().torque_j) << k;
    }
    EXPECT_GT(touching, 3000);
    EXPECT_GT(lone, touching / 4);
    RecordProperty("lone", lone);
}

// The proof that nothing else touches covers the motion for which it is used.
TEST(ConvexContact, ALoneFeatureStaysAloneAsLongAsItsRoomLasts) {
    const std::vector<ConvexSolid> solids = grains();
    Random random(12, 5);
    int used = 0;
    int outside = 0;
    for (int k = 0; k < 3000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const Host before = after_first_step(a, b, pair);
        const LoneFeature& lone = before.history.lone;
        const Leash& leash = before.history.leash;
        for (int n = 0; n < 4 && lone.kind != LoneFeature::Kind::none; ++n) {
            const double angle = leash.room * random.uniform();
            PairState moved = pair;
            moved.displacement += random.uniform(0.0, 0.7) * leash.room * random.direction();
            moved.i.orientation = turned(random.direction(), 0.3 * angle) * pair.i.orientation;
            moved.j.orientation = turned(random.direction(), 0.3 * angle) * pair.j.orientation;
            const PlacedCore i(a, moved.i.orientation, Vec3::Zero());
            const PlacedCore j(b, moved.j.orientation, moved.displacement);
            Host host;
            host.history = before.history;
            if (!holds(leash, moved, j.size) ||
                !(lone_overlap(i, j, lone, host.history.normal) > 0.0)) {
                ++outside;
                continue;
            }
            ++used;
            const PairContact quick = collide(a, b, host.call(moved, elastic, 1e-6));
            ASSERT_NE(host.history.lone.kind, LoneFeature::Kind::none);
            const PairContact whole = resting_contact(a, b, moved);
            // Rounding of the distance, relative to the overlap.
            const double bound = 1e-13 / whole.overlap + 1e-9;
            ASSERT_NEAR(quick.overlap, whole.overlap, 1e-13 + 1e-12 * whole.overlap) << k;
            ASSERT_LT((quick.force - whole.force).norm(), bound * whole.force.norm()) << k;
            ASSERT_LT((quick.torque_i - whole.torque_i).norm(), bound * whole.force.norm()) << k;
            ASSERT_LT((quick.torque_j - whole.torque_j).norm(), bound * whole.force.norm()) << k;
        }
    }
    EXPECT_GT(used, 2000);
    EXPECT_GT(outside, 50);
    RecordProperty("used", used);
}

// Nearly along the axis, what rounding leaves of a direction is as long as what lies across.
TEST(ConvexContact, TheFarthestPointOfAnEndLiesOnItHoweverSmallTheTilt) {
    Random random(12, 7);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 axis = random.direction();
        const PlacedCap cap{random.direction(), axis, 2.0, 2.0, 0.01, axis.unitOrthogonal()};
        const double tilt = std::pow(10.0, random.uniform(-13.0, 0.0));
        const Vec3 direction = turned(random.direction(), tilt) * axis;
        const Vec3 from_center = cap.support(direction, 0).position - cap.center;
        ASSERT_NEAR(from_center.dot(axis), 0.0, 1e-15) << tilt;
        ASSERT_LE(from_center.norm(), cap.radius + 1e-15) << tilt;
    }
}

// What is left out of the ends of cylinders and cones while the leash lasts adds nothing: not a bit
// changes.
TEST(ConvexContact, WhatIsLeftOutOfEndsTouchesNothing) {
    const std::vector<ConvexSolid> solids = {
        make_cylinder(0.6, 1.2, 0.02), make_cylinder(0.5, 0.1, 0.01), make_cylinder(0.3, 2.0, 0.02),
        make_cone(0.7, 1.2, 0.02), make_cuboid({1.0, 1.4, 0.6}, 0.02)};
    Random random(12, 6);
    int used = 0;
    for (int k = 0; k < 3000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const Host before = after_first_step(a, b, pair);
        const double room = before.history.leash.room;
        for (int n = 0; n < 4 && room > 0.0; ++n) {
            PairState moved = pair;
            moved.displacement += random.uniform(0.0, 0.7) * room * random.direction();
            moved.i.orientation =
                turned(random.direction(), random.uniform(0.0, 0.3) * room) * pair.i.orientation;
            Host with;
            Host without;
            with.history = without.history = before.history;
            without.history.leash.room = 0.0;
            if (!holds(before.history.leash, moved, b.bounding_radius)) continue;
            const PairContact quick = collide(a, b, with.call(moved, elastic, 1e-6));
            const PairContact whole = collide(a, b, without.call(moved, elastic, 1e-6));
            ++used;
            ASSERT_EQ(quick.overlap, whole.overlap) << k;
            ASSERT_EQ(quick.force, whole.force) << k;
            ASSERT_EQ(quick.torque_i, whole.torque_i) << k;
            ASSERT_EQ(quick.torque_j, whole.torque_j) << k;
        }
    }
    EXPECT_GT(used, 5000);
    RecordProperty("used", used);
}

}  // namespace
}  // namespace dem::test
