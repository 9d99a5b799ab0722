// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/error.hpp"
#include "common/random.hpp"
#include "shapegen/repair/repair.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"
#include "tests/shapegen/repair/closed_surface.hpp"
#include "tests/shapegen/repair/soup_of_mesh.hpp"

#include <gtest/gtest.h>

// Parts of one file that touch, cross or hold each other.

namespace dem::shapegen {
namespace {

TriangleMesh cube(const Vec3& lower, double size = 1.0) {
    return sample::box(lower, lower + Vec3::Constant(size));
}

/// The cube with the other diagonal in each face.
TriangleMesh other_cube(const Vec3& lower) {
    TriangleMesh mesh = cube(Vec3::Zero());
    for (Vec3& v : mesh.vertices) v = Vec3(v.x(), 1.0 - v.y(), v.z()) + lower;
    return sample::inside_out(mesh);
}

RepairedMesh united(const TriangleSoup& soup) {
    return repair(soup, {.limit = 0.0, .unite = true});
}

void expect_united(const TriangleMesh& parts, double volume) {
    for (const TriangleSoup& soup : {soup_of(parts), apart(parts)}) {
        const RepairedMesh result = united(soup);
        EXPECT_NEAR(enclosed_volume(result.mesh) / volume, 1.0, 1e-14);
        EXPECT_NEAR(result.report.volume / volume, 1.0, 1e-14);
        EXPECT_TRUE(is_closed_and_oriented(result.mesh));
    }
}

std::string refusal(const TriangleSoup& soup, const RepairOptions& options = {}) {
    return message_of<Error>([&] { repair(soup, options); });
}

TEST(Parts, ThatCrossBecomeTheirUnion) {
    expect_united(sample::together(cube({0, 0, 0}), cube({0.9, 0, 0})), 1.9);
    expect_united(sample::together(cube({0, 0, 0}), cube({0.5, 0.5, 0.5})), 1.875);
    expect_united(
        sample::together(sample::box({0, 0, 0}, {3, 1, 1}), sample::box({1, -1, 0}, {2, 2, 1})),
        5.0);
}

TEST(Parts, ThatShareAFaceBecomeOneHoweverItIsCut) {
    expect_united(sample::together(cube({0, 0, 0}), cube({1, 0, 0})), 2.0);
    expect_united(sample::together(cube({0, 0, 0}), other_cube({1, 0, 0})), 2.0);
    expect_united(sample::together(cube({0, 0, 0}), cube({1, 0.25, 0.25}, 0.5)), 1.125);
}

TEST(Parts, AFaceThatTwoShareExactlyGoesWithoutAsking) {
    const TriangleMesh parts = sample::together(
        cube({0, 0, 0}), sample::moved(cube({0, 0, 0}), Mat3::Identity(), Vec3(0, 0, 1)));
    const RepairedMesh result = repair(soup_of(parts));
    EXPECT_NEAR(enclosed_volume(result.mesh), 2.0, 1e-14);
    ASSERT_EQ(result.report.findings.size(), 1U);
    EXPECT_NE(result.report.findings[0].what.find("face each other"), std::string::npos);
}

TEST(Parts, WithoutUnionOneLineNamesIt) {
    for (const TriangleMesh& second :
         {cube({0.9, 0, 0}), other_cube({1, 0, 0}), cube({1, 0.25, 0.25}, 0.5)})
        for (const TriangleMesh& parts : {sample::together(cube({0, 0, 0}), second)})
            for (const TriangleSoup& soup : {soup_of(parts), apart(parts)}) {
                const std::string line = refusal(soup);
                EXPECT_NE(line.find("closed parts cross or share a face"), std::string::npos)
                    << line;
                EXPECT_NE(line.find("--union joins them"), std::string::npos) << line;
                EXPECT_EQ(line.find("holes"), std::string::npos) << line;
            }
}

TEST(Parts, APartThatAnotherHoldsCountsOnce) {
    const TriangleMesh nested = sample::together(sample::sphere(2.0, 2), sample::sphere(1.0, 2));
    expect_united(nested, enclosed_volume(sample::sphere(2.0, 2)));
    expect_united(sample::inside_out(nested), enclosed_volume(sample::sphere(2.0, 2)));
    EXPECT_NE(refusal(soup_of(nested)).find("--union"), std::string::npos);
}

TEST(Parts, HollowsStayUnlessAPartFillsThem) {
    const TriangleMesh hollow =
        sample::together(cube({0, 0, 0}, 3.0), sample::inside_out(cube({1, 1, 1})));
    expect_united(sample::together(hollow, cube({2.5, 0.5, 0.5})), 26.0 + 0.5);
    expect_united(sample::together(hollow, cube({1.5, 1.25, 1.25}, 0.5)), 26.0 + 0.125);
    expect_united(sample::together(hollow, cube({0.5, 0.5, 0.5})), 26.0 + 0.125);
    expect_united(sample::together(hollow, cube({0.5, 0.5, 0.5}, 2.0)), 27.0);
}

TEST(Parts, ThatKeepApartStayTwoBodies) {
    const TriangleMesh two = sample::together(cube({0, 0, 0}), cube({2, 0, 0}));
    EXPECT_NE(refusal(soup_of(two), {.unite = true}).find("separate bodies beside the largest: 1"),
              std::string::npos);
    const TriangleMesh three = sample::together(two, cube({2.5, 0, 0}));
    const RepairedMesh largest = repair(soup_of(three), {.keep_largest = true, .unite = true});
    EXPECT_NEAR(enclosed_volume(largest.mesh), 1.5, 1e-14);
}

TEST(Parts, ThatMeetInAnEdgeAloneStayTwoBodies) {
    const TriangleMesh cubes = sample::together(cube({0, 0, 0}), cube({1, 1, 0}));
    for (const TriangleSoup& soup : {soup_of(cubes), apart(cubes)}) {
        EXPECT_NE(refusal(soup).find("separate bodies"), std::string::npos);
        EXPECT_NE(refusal(soup, {.unite = true}).find("separate bodies"), std::string::npos);
    }
    // Half an edge: no solid whose surface is one.
    const TriangleMesh shifted = sample::together(cube({0, 0, 0}), cube({1, 1, 0.5}));
    EXPECT_NE(refusal(soup_of(shifted), {.unite = true}), "");
}

TEST(Parts, ManyThatCrossAtRandomHaveTheVolumeOfSamples) {
    Random random(21, 0);
    TriangleMesh parts;
    std::vector<std::pair<Vec3, double>> cubes;
    for (int k = 0; k < 12; ++k) {
        const Vec3 lower(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                         random.uniform(0.0, 1.0));
        cubes.emplace_back(lower, random.uniform(0.5, 0.9));
        parts = sample::together(parts, cube(lower, cubes.back().second));
    }
    const RepairedMesh result = united(soup_of(parts));
    EXPECT_TRUE(is_closed_and_oriented(result.mesh));
    // The exact volume of a union of boxes: cells between all their planes.
    std::array<std::vector<double>, 3> planes;
    for (const auto& [lower, size] : cubes)
        for (int axis = 0; axis < 3; ++axis) {
            planes[static_cast<std::size_t>(axis)].push_back(lower[axis]);
            planes[static_cast<std::size_t>(axis)].push_back(lower[axis] + size);
        }
    for (auto& list : planes) std::sort(list.begin(), list.end());
    double volume = 0.0;
    for (std::size_t i = 0; i + 1 < planes[0].size(); ++i)
        for (std::size_t j = 0; j + 1 < planes[1].size(); ++j)
            for (std::size_t k = 0; k + 1 < planes[2].size(); ++k) {
                const Vec3 low(planes[0][i], planes[1][j], planes[2][k]);
                const Vec3 high(planes[0][i + 1], planes[1][j + 1], planes[2][k + 1]);
                const Vec3 middle = 0.5 * (low + high);
                const bool is_inside = std::any_of(cubes.begin(), cubes.end(), [&](const auto& c) {
                    const Vec3 offset = middle - c.first;
                    return offset.minCoeff() > 0.0 && offset.maxCoeff() < c.second;
                });
                if (is_inside) volume += (high - low).prod();
            }
    EXPECT_NEAR(enclosed_volume(result.mesh) / volume, 1.0, 1e-13);
}

}  // namespace
}  // namespace dem::shapegen
