// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/walls/wall_shapes.hpp"

#include "common/math/rotation.hpp"
#include "common/random.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

/// What the answers of every shape that is a field have in common is held for these: a new shape
/// adds its own.
const std::vector<FieldWallShape> walls = {
    PlaneWall{},
    PlaneWall{.radius = 0.4},
    CylinderWall{.radius = 0.5},
    CylinderWall{.radius = 0.5, .length = 1.2},
    CylinderWall{.radius = 0.5, .inside = false},
    CylinderWall{.radius = 0.5, .length = 1.2, .inside = false}};

constexpr double rounding = 1e-12;

/// Calls look(field) with each wall at a place of its own.
template <class Look>
void at_places(const Look& look) {
    Random random(17, 0);
    for (std::size_t k = 0; k < walls.size(); ++k) {
        SCOPED_TRACE("wall " + std::to_string(k));
        const WallFrame frame{0.3 * random.direction(), random.direction()};
        std::visit(
            [&](const auto& wall) {
                wall.with_field(frame, 0.0, [&](const auto& field) {
                    look(frame, field, random);
                    return 0;
                });
            },
            walls[k]);
    }
}

Vec3 near_wall(const WallFrame& frame, Random& random) {
    return frame.origin + 1.5 * random.uniform() * random.direction();
}

TEST(WallShapes, TheGradientIsTheSlopeOfTheDistance) {
    at_places([](const WallFrame& frame, const auto& field, Random& random) {
        for (int trial = 0; trial < 500; ++trial) {
            const Vec3 x = near_wall(frame, random);
            const auto sample = field.sample(x);
            const Vec3 gradient = field.gradient(x, sample);
            EXPECT_NEAR(gradient.norm(), 1.0, rounding);
            const double h = 1e-6;
            const Vec3 way = h * random.direction();
            const double slope =
                (field.sample(x + way).distance - field.sample(x - way).distance) / (2.0 * h);
            if constexpr (requires { field.may_turn_within(sample, h); }) {
                if (field.may_turn_within(sample, 4.0 * h)) continue;
            }
            // Near an axis the curvature is one over the distance from it.
            if (frame.at(x).r < 0.01) continue;
            EXPECT_NEAR(gradient.dot(way) / h, slope, 1e-6);
        }
    });
}

TEST(WallShapes, NoPointThatActsIsNearerThanTheClearance) {
    at_places([](const WallFrame& frame, const auto& field, Random& random) {
        std::vector<Vec3> surface;
        for (int trial = 0; trial < 3000; ++trial) {
            Vec3 x = near_wall(frame, random);
            const auto sample = field.sample(x);
            x -= sample.distance * field.gradient(x, sample);
            const bool is_there = std::abs(field.sample(x).distance) < rounding;
            if (is_there && field.accepts(x)) surface.push_back(x);
        }
        ASSERT_GT(surface.size(), 100U);
        int exact = 0;
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 x = near_wall(frame, random);
            const double clearance = field.clearance(x);
            for (const Vec3& y : surface) EXPECT_GE((x - y).norm(), clearance - rounding);
            const auto sample = field.sample(x);
            if (!(sample.distance > 0.0)) continue;
            const Vec3 foot = x - sample.distance * field.gradient(x, sample);
            // The foot lies on the edge of a rod where rounding puts it beside.
            if (!field.accepts(foot)) continue;
            EXPECT_NEAR(clearance, sample.distance, rounding);
            ++exact;
        }
        EXPECT_GT(exact, 10);
    });
}

TEST(WallShapes, ABodyThatIsLetPassIsBehindTheWall) {
    at_places([](const WallFrame& frame, const auto& field, Random& random) {
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 x = near_wall(frame, random);
            EXPECT_TRUE(!field.lets_pass(x) || field.sample(x).distance < 0.0);
        }
    });
}

TEST(WallShapes, TheOutlineLiesOnTheSurfaceAndTheExtentHoldsIt) {
    const WallFrame frame{Vec3::Zero(), Vec3::UnitZ()};
    for (const FieldWallShape& shape : walls) {
        std::visit(
            [&](const auto& wall) {
                const WallOutline outline = wall.outline(-0.7, 0.9);
                std::vector<Vec2> points = outline.rings;
                for (const auto& line : outline.meridians)
                    points.insert(points.end(), line.begin(), line.end());
                const WallExtent extent = wall.extent();
                const bool has_ends = extent.high > extent.low;
                for (const Vec2& rz : points) {
                    const Vec3 x(0.6 * rz.x(), 0.8 * rz.x(), rz.y());
                    const double distance = wall.with_field(
                        frame, 0.0, [&](const auto& field) { return field.sample(x).distance; });
                    EXPECT_NEAR(distance, 0.0, rounding);
                    EXPECT_LE(rz.x(), extent.radius + rounding);
                    if (!has_ends) continue;
                    EXPECT_GE(rz.y(), extent.low - rounding);
                    EXPECT_LE(rz.y(), extent.high + rounding);
                }
            },
            shape);
    }
}

TEST(WallShapes, ATurnAboutTheOwnAxisMovesNoSurfaceAndATiltMovesIt) {
    Random random(3, 0);
    const Quat before = random.orientation();
    const Vec3 axis = body_axis(before);
    for (const FieldWallShape& shape : walls) {
        std::visit(
            [&](const auto& wall) {
                const Quat about_itself = rotation_about(axis, 0.3) * before;
                EXPECT_NEAR(wall.surface_turn(before, about_itself), 0.0, 1e-7);
                const Quat tilted = rotation_about(axis.unitOrthogonal(), 0.3) * before;
                EXPECT_GE(wall.surface_turn(before, tilted), 0.3 - rounding);
            },
            shape);
    }
}

TEST(WallShapes, OnlyWhatIsInFrontOfADiscOrBetweenOpenEndsIsKeptIn) {
    EXPECT_TRUE(PlaneWall{}.confines(-2.0, -1.0));
    const PlaneWall disc{.radius = 0.4};
    EXPECT_FALSE(disc.confines(-2.0, 0.0));
    EXPECT_TRUE(disc.confines(-2.0, 0.1));
    EXPECT_TRUE((CylinderWall{.radius = 0.5}.confines(5.0, 6.0)));
    const CylinderWall tube{.radius = 0.5, .length = 1.2};
    EXPECT_FALSE(tube.confines(1.2, 2.0));
    EXPECT_FALSE(tube.confines(-1.0, 0.0));
    EXPECT_TRUE(tube.confines(1.1, 2.0));
    EXPECT_FALSE((CylinderWall{.radius = 0.5, .inside = false}.confines(0.0, 1.0)));
}

}  // namespace
}  // namespace dem::test
