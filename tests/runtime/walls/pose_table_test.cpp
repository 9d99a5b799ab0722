// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/pose_table.hpp"

#include "common/math/elementary.hpp"
#include "common/math/rotation.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

/// A turn about z, while the origin goes along a circle and the axes nod.
PoseTable::Row circle(double t) {
    const double angle = 2.0 * pi * t;
    return {t,
            {math::cos(angle), math::sin(angle), 0.0},
            rotation_about(Vec3::UnitZ(), angle) *
                rotation_about(Vec3::UnitX(), 0.3 * math::sin(angle))};
}

double angle_between(const Quat& a, const Quat& b) {
    return 2.0 * (a.conjugate() * b).vec().norm();
}

struct Errors {
    double position = 0.0, angle = 0.0;
};

Errors errors_of_circle(int rows) {
    std::vector<PoseTable::Row> table;
    for (int k = 0; k <= rows; ++k) table.push_back(circle(static_cast<double>(k) / rows));
    const PoseTable poses(table);
    Errors errors;
    for (int k = 0; k <= 1000; ++k) {
        const PoseTable::Row right = circle(1e-3 * k);
        const MovingPose pose = poses.at(1e-3 * k);
        errors.position = std::max(errors.position, (pose.position - right.position).norm());
        errors.angle = std::max(errors.angle, angle_between(pose.orientation, right.orientation));
        EXPECT_NEAR(pose.orientation.norm(), 1.0, 1e-15);
    }
    return errors;
}

TEST(PoseTable, ComesToACircleWithTheThirdPowerOfTheInterval) {
    Errors coarse = errors_of_circle(16);
    EXPECT_LT(coarse.position, 0.02);
    for (const int rows : {32, 64, 128}) {
        const Errors fine = errors_of_circle(rows);
        EXPECT_LT(fine.position, coarse.position / 7.0) << rows;
        EXPECT_LT(fine.angle, coarse.angle / 7.0) << rows;
        coarse = fine;
    }
}

TEST(PoseTable, GoesThroughItsRowsWithoutAJumpOfVelocity) {
    std::vector<PoseTable::Row> rows;
    for (const double t : {0.0, 0.1, 0.13, 0.4, 0.55, 0.9}) rows.push_back(circle(t));
    const PoseTable poses(rows);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const MovingPose pose = poses.at(rows[k].time);
        EXPECT_LT((pose.position - rows[k].position).norm(), 1e-15);
        EXPECT_LT(angle_between(pose.orientation, rows[k].orientation), 1e-15);
        if (k == 0 || k + 1 == rows.size()) continue;
        const MovingPose before = poses.at(rows[k].time - 1e-9);
        EXPECT_LT((pose.velocity - before.velocity).norm(), 1e-6);
        EXPECT_LT((pose.angular_velocity - before.angular_velocity).norm(), 1e-6);
    }
}

TEST(PoseTable, StandsBetweenRowsOfOnePose) {
    const Quat turned = rotation_about(Vec3::UnitY(), 1.0);
    const PoseTable poses({{0.0, {1.0, 0.0, 0.0}, Quat::Identity()},
                           {1.0, {2.0, 0.0, 0.0}, turned},
                           {2.0, {2.0, 0.0, 0.0}, turned},
                           {3.0, {5.0, 0.0, 0.0}, Quat::Identity()}});
    for (const double t : {1.0, 1.2, 1.5, 1.99}) {
        const MovingPose pose = poses.at(t);
        EXPECT_NEAR(pose.position.x(), 2.0, 1e-14);
        EXPECT_LT(angle_between(pose.orientation, turned), 1e-15);
        EXPECT_EQ(pose.angular_velocity, Vec3::Zero());
    }
}

TEST(PoseTable, OfTwoRowsIsAStraightLineAndAnEvenTurn) {
    const PoseTable poses({{1.0, {0.0, 0.0, 0.0}, Quat::Identity()},
                           {3.0, {0.0, 4.0, 0.0}, rotation_about(Vec3::UnitX(), 2.0)}});
    const MovingPose pose = poses.at(1.5);
    EXPECT_NEAR(pose.position.y(), 1.0, 1e-15);
    EXPECT_LT(angle_between(pose.orientation, rotation_about(Vec3::UnitX(), 0.5)), 1e-15);
    EXPECT_TRUE(pose.angular_velocity.isApprox(Vec3(1.0, 0.0, 0.0), 1e-14));
}

}  // namespace
}  // namespace dem::runtime
