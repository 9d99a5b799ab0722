// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/build_clump.hpp"

#include "common/error.hpp"
#include "common/threads/thread_team.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

TriangleMesh ellipsoid() {
    const Mat3 axes = Vec3(1.5, 1.0, 0.8).asDiagonal();
    return sample::moved(sample::sphere(1.0, 4), axes, Vec3(3.0, -2.0, 0.5));
}

BuiltClump build_clump(const TriangleMesh& mesh, const ClumpOptions& options,
                       const CoverGoal& goal) {
    const MassProperties properties = mass_properties(mesh);
    const Mat3 to_body = properties.principal_axes.toRotationMatrix().transpose();
    TriangleMesh turned = mesh;
    for (Vec3& p : turned.vertices) p = to_body * (p - properties.center_of_mass);
    return ClumpMaker(std::move(turned), properties, options).clump(goal);
}

CoverGoal coverage(double share) {
    return {share, SIZE_MAX};
}
CoverGoal count(std::size_t spheres) {
    return {1.0, spheres};
}

ClumpOptions coarse() {
    ClumpOptions options;
    options.per_diameter = 30.0;
    options.cells_per_diameter = 60.0;
    return options;
}

TEST(BuildClump, InscribedSpheresReachTheCoverage) {
    ClumpOptions options = coarse();
    options.is_inscribed = true;
    const BuiltClump clump = build_clump(ellipsoid(), options, coverage(0.93));
    EXPECT_GE(clump.quality.coverage, 0.93);
    EXPECT_EQ(clump.quality.outside, 0.0);
    EXPECT_LE(clump.quality.max_deviation_out, 1e-9);
    EXPECT_GT(clump.ceiling, 0.97);
    EXPECT_LT(clump.balls.size(), 30U);
}

TEST(BuildClump, FitHalvesTheDeviation) {
    ClumpOptions options = coarse();
    options.protrusion = 0.03;
    const BuiltClump fitted = build_clump(ellipsoid(), options, count(20));
    options.is_inscribed = true;
    const BuiltClump inscribed = build_clump(ellipsoid(), options, count(20));
    ASSERT_EQ(fitted.balls.size(), 20U);
    EXPECT_LT(fitted.quality.rms_deviation, 0.6 * inscribed.quality.rms_deviation);
    EXPECT_LE(fitted.quality.max_deviation_out, options.protrusion + 1e-9);
    EXPECT_NEAR(fitted.quality.volume_ratio, 1.0, 0.001);
    EXPECT_LT(fitted.quality.moment_errors.cwiseAbs().maxCoeff(), 0.01);
}

TEST(BuildClump, IsTheSameForAnyNumberOfThreads) {
    ClumpOptions options = coarse();
    const BuiltClump one = build_clump(ellipsoid(), options, count(12));
    ThreadTeam team(3);
    const ThreadTeam::InForce together(&team);
    const BuiltClump three = build_clump(ellipsoid(), options, count(12));
    ASSERT_EQ(one.balls.size(), three.balls.size());
    for (std::size_t i = 0; i < one.balls.size(); ++i) {
        EXPECT_EQ(one.balls[i].center, three.balls[i].center);
        EXPECT_EQ(one.balls[i].radius, three.balls[i].radius);
    }
}

TEST(BuildClump, SaysTheCeilingOfWhatCannotBeReached) {
    ClumpOptions options = coarse();
    options.min_radius = 0.2;
    try {
        build_clump(sample::box(Vec3::Zero(), Vec3(1.0, 2.0, 3.0)), options, coverage(0.99));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("expected at most 0."), std::string::npos);
    }
}

}  // namespace
}  // namespace dem::shapegen
