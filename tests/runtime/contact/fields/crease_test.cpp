// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/fields/crease.hpp"

#include "common/random.hpp"
#include "runtime/contact/fields/core_field.hpp"
#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"
#include "tests/support/sample_convex.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace dem::runtime {

using namespace shapegen;

namespace {

const RodField rod{{0.0}, Vec3::Zero(), Vec3::UnitZ(), 5e-3, 1e-2};

TEST(Crease, EachOfTwoFacesActsForItsPartOfTheStep) {
    // Half a step before x the side is nearer by 1 um, half a step after the end by 3 um.
    const Vec3 x(5e-3 - 1e-4, 0.0, 1e-2 - 1e-4 + 1e-6);
    const Vec3 way(-2e-6, 0.0, 2e-6);
    const StepMean mean = step_mean(rod, x, rod.sample(x), way);
    EXPECT_NEAR(mean.gradient.x(), 0.25, 1e-6);
    EXPECT_NEAR(mean.gradient.z(), 0.75, 1e-6);
    EXPECT_EQ(mean.gradient.y(), 0.0);
    // From -99 um down to -99.5 um at the crease, and up to -98 um.
    EXPECT_NEAR(mean.distance, -1e-6 * (0.25 * 99.25 + 0.75 * 98.75), 1e-12);
}

TEST(Crease, AStepThatEndsBeforeACreaseKeepsTheGradientOfItsFace) {
    const Vec3 x(5e-3 - 1e-4, 0.0, 1e-2 - 1e-4 + 2.1e-6);
    const Vec3 mean = step_mean(rod, x, rod.sample(x), Vec3(-2e-6, 0.0, 2e-6)).gradient;
    EXPECT_EQ(mean, Vec3::UnitZ());
}

/// What a force along the mean does on the way is what the distance changes by, through creases
/// and where several faces come into one step.
template <class Field>
void expect_work_of(const Field& field, const Vec3& x, const Vec3& way) {
    const Vec3 mean = step_mean(field, x, field.sample(x), way).gradient;
    const double change =
        field.sample(x + 0.5 * way).distance - field.sample(x - 0.5 * way).distance;
    EXPECT_NEAR(mean.dot(way), change, 1e-6 * way.norm()) << x.transpose();
    EXPECT_LE(mean.norm(), 1.0 + 1e-12);
}

TEST(Crease, TheMeanGradientTimesTheWayIsTheChangeOfTheDistance) {
    Random random(4, 0);
    const auto points = [&] {
        std::vector<Vec3> all;
        for (int k = 0; k < 12; ++k) all.push_back(5e-3 * random.direction());
        return all;
    }();
    const std::array<ConvexSolid, 3> solids = {make_cylinder(4e-3, 8e-3, 2e-4),
                                               make_cone(4e-3, 8e-3, 2e-4),
                                               test::rounded_hull(points, 2e-4)};
    for (const ConvexSolid& solid : solids) {
        const ConvexField field{{0.0}, &solid.shape, Mat3::Identity(), Vec3::Zero()};
        for (int trial = 0; trial < 2000; ++trial) {
            // The creases are where the nearest face changes on a straight line.
            Vec3 a = 3e-3 * random.direction();
            Vec3 b = 3e-3 * random.direction();
            const Vec3 normal = field.sample(a).normal;
            if (normal.dot(field.sample(b).normal) > 0.99) continue;
            for (int k = 0; k < 30; ++k) {
                const Vec3 middle = 0.5 * (a + b);
                (normal.dot(field.sample(middle).normal) > 0.99 ? a : b) = middle;
            }
            if (!field.may_turn_within(field.sample(a), 2e-6)) continue;  // outside of the core
            expect_work_of(field, a, 2e-6 * random.direction());
        }
    }
}

TEST(Crease, AStrictlyConvexBodyHasNone) {
    const ConvexSolid solid = make_ellipsoid(Vec3(3e-3, 2e-3, 1e-3));
    const ConvexField field{{0.0}, &solid.shape, Mat3::Identity(), Vec3::Zero()};
    const Vec3 x(1e-4, 2e-4, -3e-4);
    EXPECT_EQ(step_mean(field, x, field.sample(x), Vec3(1e-3, 0.0, 1e-3)).gradient,
              field.gradient(x, field.sample(x)));
}

TEST(Crease, TheWayOfAPointIsThatOfItsBodyRelativeToTheOther) {
    Random random(6, 0);
    for (const double sign : {1.0, -1.0}) {
        PairState pair;
        pair.displacement = 5e-3 * random.direction();
        pair.i.velocity = random.direction();
        pair.j.velocity = random.direction();
        pair.i.angular_velocity = 100.0 * random.direction();
        pair.j.angular_velocity = 100.0 * random.direction();
        const Mat3 to_world = random.orientation().toRotationMatrix();
        const Vec3 center = sign > 0.0 ? Vec3::Zero() : pair.displacement;
        const Vec3 x = 3e-3 * random.direction();
        const Vec3 place = center + to_world * x;
        const Vec3 of_i = pair.i.velocity + pair.i.angular_velocity.cross(place);
        const Vec3 of_j =
            pair.j.velocity + pair.j.angular_velocity.cross(place - pair.displacement);
        const Vec3 way = step_way(pair, to_world, center, sign, 1e-6).at(x);
        EXPECT_LT((to_world * way - sign * 1e-6 * (of_i - of_j)).norm(), 1e-18);
    }
}

}  // namespace
}  // namespace dem::runtime
