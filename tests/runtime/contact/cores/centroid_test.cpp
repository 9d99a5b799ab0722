// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/centroid.hpp"

#include "runtime/contact/cores/core_pair.hpp"
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

// Against sums over a fine grid of points in both polygons.
TEST(ConvexContact, CentroidOfACommonPatchIsThatOfItsPoints) {
    Random random(5, 2);
    const auto polygon = [&](std::size_t count) {
        std::vector<Vec2> points;
        for (std::size_t k = 0; k < count; ++k)
            points.emplace_back(random.uniform(), random.uniform());
        return points;
    };
    const auto holds = [](const std::vector<Vec2>& points, const Vec2& x) {
        // x is in the hull unless some line through it leaves all points on one side.
        for (int k = 0; k < 720; ++k) {
            const Vec2 n(std::cos(k * pi / 360.0), std::sin(k * pi / 360.0));
            if (std::all_of(points.begin(), points.end(),
                            [&](const Vec2& p) { return n.dot(p - x) < 0.0; }))
                return false;
        }
        return true;
    };
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<Vec2> a = polygon(6);
        std::vector<Vec2> b = polygon(5);
        Vec2 sum = Vec2::Zero();
        int inside = 0;
        for (int n = 0; n < 1600; ++n) {
            const Vec2 x((n % 40 + 0.5) / 40.0, (n / 40 + 0.5) / 40.0);
            if (!holds(a, x) || !holds(b, x)) continue;
            sum += x;
            ++inside;
        }
        Vec2 centroid;
        ASSERT_EQ(common_centroid(a, b, centroid), inside > 0);
        if (inside == 0) continue;
        EXPECT_LT((centroid - sum / inside).norm(), 0.02) << trial;
    }
    // A segment across a square, and two segments along each other.
    std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Vec2> line{{-1, 0.25}, {0.5, 0.25}};
    std::vector<Vec2> along{{0, 0.25}, {3, 0.25}};
    Vec2 centroid;
    ASSERT_TRUE(common_centroid(square, line, centroid));
    EXPECT_LT((centroid - Vec2(0.25, 0.25)).norm(), 1e-12);
    ASSERT_TRUE(common_centroid(line, along, centroid));
    EXPECT_LT((centroid - Vec2(0.25, 0.25)).norm(), 1e-12);
}

// A cube on a shifted cube: one force through the middle of the rectangle they share, and the same
// overlap as by features.
TEST(ConvexContact, CentroidRuleActsInTheMiddleOfThePatch) {
    const ConvexSolid cube = make_cuboid(Vec3::Ones(), 0.01);
    const PairState pair{{0.3, 0.2, -0.999}, still(Quat::Identity()), still(Quat::Identity())};
    ContactLaw law = elastic;
    law.geometry.method = ContactLaw::Method::centroid;
    Host host;
    host.history.effective_radius = 0.25;
    host.history.search.direction = Vec3(0.0, 0.0, 1.0);
    const PairContact contact = collide(cube.shape, cube.shape, host.call(pair, law, 1e-6));
    ASSERT_EQ(contact.points, 1U);
    EXPECT_NEAR(contact.overlap, 1e-3, 1e-9);
    EXPECT_LT((contact.force.normalized() - Vec3::UnitZ()).norm(), 1e-9);
    const Vec3 lever(0.15, 0.1, -0.4995);
    EXPECT_LT((contact.torque_i - lever.cross(contact.force)).norm(), 1e-6 * contact.force.norm());
    EXPECT_FALSE(contact.cores_met);
}

}  // namespace
}  // namespace dem::test
