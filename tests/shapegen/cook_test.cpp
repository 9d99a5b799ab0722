// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/pipeline/cook.hpp"

#include "common/error.hpp"
#include "shapegen/certificate/sr_certificate.hpp"
#include "tests/shapegen/sample_profiles.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

double certified(const ParticleTemplate& shape, const std::string& name) {
    for (const auto& [key, value] : shape.certificate) {
        if (key == name) return value;
    }
    ADD_FAILURE() << shape.name << " has no " << name;
    return 0.0;
}

TEST(Cook, KeepsEveryErrorBelowWhatThePapersAskFor) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const ParticleTemplate shape = cook(profile, name, {});
        EXPECT_LT(certified(shape, "sdf_error_mean"), 2e-5) << name;
        EXPECT_LT(certified(shape, "volume_error"), 1e-9) << name;
        EXPECT_LT(certified(shape, "curvature_error_max"), 2e-3) << name;
        EXPECT_LT(certified(shape, "display_mesh_error_max"), 1.05e-3) << name;
        EXPECT_LT(certified(shape, "node_surface_error_max"), 3e-3) << name;
        if (!shape.is_convex) continue;
        EXPECT_LE(certified(shape, "support_error_max"), 3.1e-5) << name;
    }
}

TEST(Cook, PutsTheOriginIntoTheCenterOfMass) {
    const Profile low = test::tablet().translated(-7e-3);
    const ParticleTemplate shape = cook(low, "low", {});
    EXPECT_NEAR(shape.mass_properties.center_of_mass.z(), -7e-3, 1e-15);
    const auto& sr = std::get<SrShape>(shape.shape);
    EXPECT_NEAR(sr.bottom_z, -3.23e-3, 1e-15);
    EXPECT_NEAR(sr.top_z, 3.23e-3, 1e-15);
    EXPECT_NEAR(sr.major_axis_length, 11.35e-3, 1e-15);
    EXPECT_NEAR(shape.bounding_radius, std::hypot(5.675e-3, 2e-3), 1e-15);
}

TEST(Cook, BoundsEveryPointOfTheBody) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const ParticleTemplate shape = cook(profile, name, {});
        const double limit = shape.bounding_radius * (1.0 + 1e-15);
        for (const auto& node : std::get<SrShape>(shape.shape).nodes.nodes) {
            EXPECT_LE(Vec3(node.x, node.y, node.z).norm(), limit) << name;
        }
        for (const Vec3& v : shape.display_mesh.vertices) EXPECT_LE(v.norm(), limit) << name;
    }
}

TEST(Cook, GivesNodesTheCurvatureOfTheSurfaceAndEdgesTheClampedOne) {
    const ParticleTemplate shape = cook(test::cylinder(3e-3, 4e-3), "cylinder", {});
    const auto& sr = std::get<SrShape>(shape.shape);
    for (std::uint32_t i = 0; i < sr.nodes.count; ++i) {
        const auto& node = sr.nodes.nodes[i];
        const bool on_side = std::abs(std::hypot(node.x, node.y) - 3e-3) < 1e-15;
        const bool on_face = std::abs(std::abs(node.z) - 2e-3) < 1e-15;
        const double expected = on_side && on_face ? 100.0 / sr.equivalent_diameter
                                : on_side          ? 0.5 / 3e-3
                                                   : 0.0;
        EXPECT_NEAR(node.mean_curvature, expected, 1e-9 * (expected + 1.0));
    }
}

TEST(Cook, DoublesTheMeasuredErrorsForTheSlacks) {
    const ParticleTemplate shape = cook(test::tablet(), "tablet", {});
    const auto& sr = std::get<SrShape>(shape.shape);
    const double l = sr.major_axis_length;
    EXPECT_GE(sr.sdf.surface_slack, 2.0 * certified(shape, "sdf_error_max") * l);
    EXPECT_GE(sr.sdf.lipschitz_slack, sr.sdf.surface_slack);
    EXPECT_NEAR(sr.sdf.surface_band, l / 200.0, 1e-15);
}

TEST(Cook, MakesAnExactSphereOnlyOfASphere) {
    CookOptions options;
    options.kind = CookOptions::Kind::sphere;
    const ParticleTemplate ball = cook(test::spheroid(2e-3, 2e-3), "ball", options);
    EXPECT_NEAR(std::get<Sphere>(ball.shape).radius, 2e-3, 1e-16);
    EXPECT_NEAR(ball.bounding_radius, 2e-3, 1e-16);
    EXPECT_THROW(cook(test::spheroid(2e-3, 2.0001e-3), "egg", options), Error);
}

TEST(PolygonVolume, IsIndependentOfTheClosedFormAndAgrees) {
    EXPECT_NEAR(polygon_volume(test::candy()), 6.166517e-7, 1e-13);
    EXPECT_NEAR(polygon_volume(test::tablet()), 5.311042e-7, 1e-13);
}

}  // namespace
}  // namespace dem::shapegen
