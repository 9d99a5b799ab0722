// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/ball_tree.hpp"
#include "shapegen/clump/candidates.hpp"
#include "shapegen/clump/components.hpp"
#include "shapegen/clump/judge.hpp"
#include "shapegen/clump/mass_balance.hpp"
#include "shapegen/clump/sample_blocks.hpp"
#include "shapegen/voxel/voxelize.hpp"
#include "tests/shapegen/clump/sample_balls.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

TEST(MaximalBall, OfABoxTouchesBothFaces) {
    const SurfaceQuery box(sample::box(Vec3(0, 0, 0), Vec3(4, 6, 2)));
    // From the face z = 0, far from the sides: between top and bottom.
    const auto middle = maximal_ball(box, Vec3(1.5, 3.0, 0.0), Vec3::UnitZ(), 5.0);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->radius, 1.0, 1e-6);
    EXPECT_NEAR(middle->center.z(), 1.0, 1e-6);
    // Near the side x = 0: as far from it as from the bottom.
    const auto corner = maximal_ball(box, Vec3(0.3, 3.0, 0.0), Vec3::UnitZ(), 5.0);
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->radius, 0.3, 1e-6);
}

TEST(Candidates, AreInsideAndTouchTheSurface) {
    const SurfaceQuery torus(sample::torus(2.0, 0.7, 40, 24));
    const VoxelImage image = voxelize(torus.mesh(), 0.1);
    for (const auto& balls : {skeletal_balls(torus, image, Skeleton::surface, 0.05),
                              surface_seeded_balls(torus, 300, {}, 0.0, 0.05)}) {
        ASSERT_GT(balls.size(), 100U);
        for (const Ball& ball : balls) {
            EXPECT_TRUE(torus.is_inside(ball.center));
            EXPECT_EQ(ball.radius, torus.distance(ball.center));
            EXPECT_GT(ball.radius, 0.05);
        }
    }
}

TEST(Components, AreThoseThatALoopOverAllPairsFinds) {
    for (const std::size_t count : {1U, 7U, 40U, 300U}) {
        // Sparse enough for many pieces.
        std::vector<Ball> balls = test::random_balls(count, 50 + count);
        for (Ball& ball : balls) ball.radius *= 0.3;
        std::vector<ClumpSphere> spheres;
        for (const Ball& b : balls)
            spheres.push_back({b.center.x(), b.center.y(), b.center.z(), b.radius, 1.0});
        // Every ball gets the lowest index that it can be reached from.
        std::vector<std::size_t> label(count);
        for (std::size_t i = 0; i < count; ++i) label[i] = i;
        for (std::size_t round = 0; round < count; ++round)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < count; ++j)
                    if ((balls[i].center - balls[j].center).norm() <=
                        balls[i].radius + balls[j].radius)
                        label[i] = label[j] = std::min(label[i], label[j]);
        std::size_t expected = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (label[i] == i) ++expected;
        EXPECT_EQ(component_count(make_clump(spheres)), expected) << count;
        EXPECT_TRUE(count != 40U || expected > 3U) << expected;
    }
}

TEST(Components, SpheresThatTouchAreOnePiece) {
    EXPECT_EQ(component_count(make_clump({{0, 0, 0, 0.1, 1}, {0, 0, 0.3, 0.2, 1}})), 1U);
    EXPECT_EQ(component_count(make_clump({{0, 0, 0, 0.1, 1}, {0, 0, 0.3001, 0.2, 1}})), 2U);
}

TEST(BallTree, AnswersAsALoopDoes) {
    const std::vector<Ball> balls = test::random_balls(200, 5);
    const BallTree tree(balls);
    Random random(6, 0);
    for (int n = 0; n < 500; ++n) {
        const Vec3 x = 1.5 * random.uniform() * random.direction();
        BallTree::Answer best{0, 1e30};
        for (std::uint32_t i = 0; i < balls.size(); ++i) {
            const double distance = (x - balls[i].center).norm() - balls[i].radius;
            if (distance < best.distance) best = {i, distance};
        }
        const auto likely = static_cast<std::uint32_t>(n % 200);  // right or wrong
        EXPECT_EQ(tree.nearest(x, likely).ball, best.ball);
        EXPECT_EQ(tree.nearest(x, likely).distance, best.distance);
        std::vector<std::uint32_t> meeting;
        const Ball other{x, 0.2};
        const double smallest = n % 2 == 0 ? 0.0 : 0.1;
        tree.visit_meeting(other, smallest, [&](std::uint32_t i) { meeting.push_back(i); });
        std::sort(meeting.begin(), meeting.end());
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < balls.size(); ++i)
            if (balls[i].radius >= smallest &&
                (balls[i].center - x).norm() < balls[i].radius + other.radius)
                expected.push_back(i);
        EXPECT_EQ(meeting, expected);
    }
}

TEST(SampleBlocks, AnswerAsTheTreeDoes) {
    const std::vector<SurfaceSample> samples = surface_samples(sample::sphere(1.0, 4), 5003);
    for (const std::size_t count : {1U, 7U, 400U}) {
        const std::vector<Ball> balls = test::random_balls(count, 8);
        const BallTree tree(balls);
        const auto answers = SampleBlocks(samples).nearest(tree, balls);
        ASSERT_EQ(answers.size(), samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const BallTree::Answer expected = tree.nearest(samples[i].point);
            ASSERT_EQ(answers[i].ball, expected.ball);
            ASSERT_EQ(answers[i].distance, expected.distance);
        }
    }
}

TEST(Judge, KnowsAConcentricBall) {
    const SurfaceQuery sphere(sample::sphere(1.0, 6));
    const MassProperties body = mass_properties(sphere.mesh());
    const std::vector<Ball> inner{{Vec3::Zero(), 0.9}};
    const ClumpQuality q = judge(sphere, body.volume, inner);
    EXPECT_NEAR(q.coverage, cube(0.9), 3e-4);
    EXPECT_EQ(q.outside, 0.0);
    EXPECT_NEAR(q.volume_ratio, cube(0.9), 3e-4);
    EXPECT_NEAR(q.rms_deviation, 0.05, 1e-4);
    EXPECT_NEAR(q.max_deviation_in, 0.05, 1e-4);
    EXPECT_EQ(q.max_deviation_out, 0.0);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(q.moment_errors[axis], std::pow(0.9, 5) - 1.0, 1e-3);
    EXPECT_LT(q.slope_rms, 0.02);
    const std::vector<Ball> outer{{Vec3::Zero(), 1.1}};
    const ClumpQuality p = judge(sphere, body.volume, outer);
    EXPECT_EQ(p.coverage, 1.0);
    EXPECT_NEAR(p.outside, cube(1.1) - 1.0, 5e-4);
}

/// What the sums over spheres are, as a program that adds spheres up computes them.
void expect_balanced(const std::vector<Ball>& balls, const MassBalance& balance,
                     const MassProperties& body, double tolerance) {
    double mass = 0.0;
    Vec3 center = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double m = balance.shares[i];
        const Vec3& c = balls[i].center;
        EXPECT_GE(m, 0.0);
        mass += m;
        center += m * c;
        inertia += m * ((c.squaredNorm() + 0.4 * square(balls[i].radius)) * Mat3::Identity() -
                        c * c.transpose());
    }
    EXPECT_NEAR(mass, body.volume, 1e-9 * body.volume);
    EXPECT_NEAR(center.norm(), 0.0, 1e-9 * body.volume);
    const Mat3 wanted = body.principal_moments_per_density.asDiagonal();
    EXPECT_LE((inertia - wanted).cwiseAbs().maxCoeff(),
              (tolerance + 1e-8) * body.principal_moments_per_density.maxCoeff());
}

TEST(MassBalance, MeetsMassCenterAndInertia) {
    const std::vector<Ball> balls = test::random_balls(60, 7);
    MassProperties body;
    body.volume = 3.0;
    body.principal_moments_per_density = Vec3(2.2, 2.0, 1.7);
    const MassBalance balance = balance_masses(balls, body);
    EXPECT_EQ(balance.tolerance, 0.0);
    expect_balanced(balls, balance, body, 0.0);
}

// Whether the spheres can have the body's moments or not: none is negative, their sum is the body.
TEST(MassBalance, MeetsTheMassOfAnyClump) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const std::vector<Ball> balls = test::random_balls(3 + 2 * seed, seed);
        MassProperties body;
        body.volume = 3.0;
        body.principal_moments_per_density = Vec3(2.2, 2.0, 0.4 + 0.1 * seed);
        double sum = 0.0;
        for (const double share : balance_masses(balls, body).shares) {
            EXPECT_GE(share, 0.0);
            sum += share;
        }
        EXPECT_NEAR(sum, body.volume, 1e-12 * body.volume) << balls.size() << " spheres";
    }
}

TEST(MassBalance, AllowsTheErrorItNeeds) {
    // Two balls on a line have no freedom but their sizes: their moments are 1.24 and 0.24.
    const std::vector<Ball> balls{{Vec3(-1, 0, 0), std::sqrt(0.6)},
                                  {Vec3(1, 0, 0), std::sqrt(0.6)}};
    MassProperties body;
    body.volume = 1.0;
    body.principal_moments_per_density = Vec3(0.24, 1.24, 1.24 / 1.1);
    const MassBalance balance = balance_masses(balls, body);
    EXPECT_NEAR(balance.tolerance, 0.1, 1e-3);
    expect_balanced(balls, balance, body, balance.tolerance);
}

}  // namespace
}  // namespace dem::shapegen
