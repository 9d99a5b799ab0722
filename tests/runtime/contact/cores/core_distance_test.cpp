// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/epa.hpp"
#include "runtime/contact/cores/gjk.hpp"
#include "runtime/contact/cores/placed_core.hpp"
#include "tests/runtime/contact/cores/convex_poses.hpp"
#include "tests/runtime/contact/cores/polyhedron_gap.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

/// How far two cores are apart, or how deep they overlap.
namespace dem::test {

using namespace runtime;

namespace {

TEST(Gjk, MeetsTheDistanceOfAllFeaturesForAnyTiltAndGap) {
    const std::vector<ConvexSolid> solids{make_cuboid({1.0, 1.0, 1.0}, 0.05),
                                          random_polyhedron(20, 1, 0.02),
                                          rounded_hull(tetrahedron_corners(1.5), 0.03)};
    Random random(8, 1);
    int compared = 0;
    double worst = 0.0;
    for (int k = 0; k < 400; ++k) {
        const ConvexShape& a = solids[static_cast<std::size_t>(k) % 3].shape;
        const ConvexShape& b = solids[static_cast<std::size_t>(k) / 3 % 3].shape;
        const double tilt = k % 4 == 0 ? pi : k % 4 == 1 ? 0.0 : std::pow(10.0, -0.02 * k);
        const Poses p = random_poses(random, tilt);
        const double gap = std::pow(10.0, random.uniform(-6.0, -1.0));
        const auto pair_at = [&](double x) {
            return PairState{x * p.direction + p.offset, still(p.i), still(p.j)};
        };
        const auto distance_at = [&](const PairState& at) {
            return polyhedron_gap(PlacedCore(a, at.i.orientation, Vec3::Zero()),
                                  PlacedCore(b, at.j.orientation, at.displacement))
                .distance;
        };
        const double x = place_of(
            -gap, 4.0, [&](double y) { return -distance_at(pair_at(y)) - (y < 0.3 ? -1.0 : 0.0); });
        const PairState pair = pair_at(x);
        const double expected = distance_at(pair);
        if (!(expected > 0.0) || expected > 1.0) continue;
        const PlacedCore i(a, p.i, Vec3::Zero());
        const PlacedCore j(b, p.j, pair.displacement);
        SearchStart start;
        start.direction = Vec3(-pair.displacement.normalized());
        const CoreDistance found = core_distance(i, j, start, 0.0);
        if (found.overlaps) continue;
        ++compared;
        worst = std::max(worst, std::abs(found.distance - expected));
        ASSERT_LT(found.evaluations, 40) << k;
        // Started from its own end the search stops at once.
        const CoreDistance again = core_distance(i, j, next_start(i, j, found), 0.0);
        ASSERT_LE(again.evaluations, 2) << k;
        ASSERT_NEAR(again.distance, found.distance, 1e-12) << k;
    }
    EXPECT_GT(compared, 100);
    EXPECT_LT(worst, 1e-12);
}

TEST(Gjk, ProvesItsDistanceForRoundCores) {
    const auto solids = convex_solids();
    Random random(9, 1);
    for (int k = 0; k < 4000; ++k) {
        const ConvexShape& a = solids[static_cast<std::size_t>(k) % solids.size()].second.shape;
        const ConvexShape& b =
            solids[static_cast<std::size_t>(k) / 10 % solids.size()].second.shape;
        const Poses p =
            random_poses(random, k % 3 == 0 ? pi : std::pow(10.0, random.uniform(-8, 0)));
        const Vec3 d = random.uniform(0.8, 2.5) * p.direction + p.offset;
        const PlacedCore i(a, p.i, Vec3::Zero());
        const PlacedCore j(b, p.j, d);
        SearchStart start;
        start.direction = Vec3(-d.normalized());
        const CoreDistance found = core_distance(i, j, start, 0.0);
        if (found.overlaps) continue;
        // Both points lie in the cores, and no two points can be nearer along the normal.
        ASSERT_LT(core_distance(a, i.in_body(found.point_i)).distance, 1e-10);
        ASSERT_LT(core_distance(b, j.in_body(found.point_j)).distance, 1e-10);
        const double proven = found.normal.dot(i.support(-found.normal, 0).position -
                                               j.support(found.normal, 0).position);
        ASSERT_NEAR(proven, found.distance, 1e-7) << k;
    }
}

TEST(Epa, FindsTheDepthAlongTheBestOfManyDirections) {
    const std::vector<ConvexSolid> solids{make_cuboid({1.0, 1.2, 0.8}, 0.01),
                                          random_polyhedron(20, 1, 0.02),
                                          make_cylinder(0.5, 1.0, 0.01)};
    Random random(10, 1);
    for (int k = 0; k < 200; ++k) {
        const ConvexShape& a = solids[static_cast<std::size_t>(k) % 3].shape;
        const ConvexShape& b = solids[static_cast<std::size_t>(k) / 3 % 3].shape;
        const Poses p = random_poses(random, k % 2 == 0 ? pi : 1e-6);
        const PlacedCore i(a, p.i, Vec3::Zero());
        const PlacedCore j(b, p.j, random.uniform(0.3, 0.8) * p.direction);
        const Penetration found = core_penetration(i, j);
        ASSERT_TRUE(found.converged) << k;
        const auto overlap_along = [&](const Vec3& n) {
            return n.dot(j.support(n, 0).position - i.support(-n, 0).position);
        };
        ASSERT_NEAR(overlap_along(found.normal), found.depth, 1e-7) << k;
        for (int trial = 0; trial < 200; ++trial)
            ASSERT_GE(overlap_along(random.direction()), found.depth - 1e-8) << k;
    }
}

}  // namespace
}  // namespace dem::test
