// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/repair.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"
#include "tests/shapegen/repair/closed_surface.hpp"
#include "tests/shapegen/repair/soup_of_mesh.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

const Finding* find(const RepairReport& report, const std::string& what) {
    for (const Finding& finding : report.findings)
        if (finding.what == what) return &finding;
    return nullptr;
}

std::size_t count(const RepairReport& report, const std::string& what) {
    const Finding* finding = find(report, what);
    return finding == nullptr ? 0 : finding->count;
}

std::string refusal(const TriangleSoup& soup, const RepairOptions& options = {}) {
    return message_of<Error>([&] { repair(soup, options); });
}

TEST(Repair, WhatIsSoundStaysAsItIs) {
    for (const TriangleMesh& mesh : {sample::sphere(1.0, 3), sample::torus(3.0, 1.0, 24, 12),
                                     sample::box({0, 0, 0}, {1, 2, 3})}) {
        const RepairedMesh repaired = repair(soup_of(mesh), {.limit = 0.0});
        EXPECT_TRUE(repaired.report.findings.empty());
        EXPECT_EQ(repaired.mesh.vertices, mesh.vertices);
        EXPECT_EQ(repaired.mesh.triangles.size(), mesh.triangles.size());
        EXPECT_EQ(enclosed_volume(repaired.mesh), enclosed_volume(mesh));
        EXPECT_NEAR(repaired.report.volume / enclosed_volume(mesh), 1.0, 1e-13);
    }
}

TEST(Repair, TrianglesApartAndAtRandomTurnedBecomeASurface) {
    Random random(3, 0);
    const TriangleMesh mesh = sample::torus(3.0, 1.0, 24, 12);
    TriangleSoup soup = apart(mesh);
    std::size_t turned = 0;
    for (auto& triangle : soup.triangles)
        if (random.uniform() < 0.3) {
            std::swap(triangle[0], triangle[2]);
            ++turned;
        }
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(count(repaired.report, "triangles facing against their neighbors"), turned);
    EXPECT_EQ(repaired.report.findings.size(), 1U);
    EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    EXPECT_EQ(repaired.mesh.vertices.size(), mesh.vertices.size());
    EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(mesh), 1e-12);
}

TEST(Repair, AnySizeGetsTheSameTreatment) {
    TriangleMesh damaged = sample::sphere(1.0, 3);
    damaged.triangles.erase(damaged.triangles.begin() + 17);
    std::swap(damaged.triangles[5][0], damaged.triangles[5][1]);
    for (const double size : {1e-9, 1.0, 1e9}) {
        const RepairedMesh repaired =
            repair(soup_of(sample::moved(damaged, size * Mat3::Identity(), Vec3::Zero())));
        EXPECT_EQ(count(repaired.report, "holes"), 1U);
        EXPECT_EQ(count(repaired.report, "triangles facing against their neighbors"), 1U);
        EXPECT_EQ(repaired.report.findings.size(), 2U);
        EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    }
}

TEST(Repair, DuplicatesGoAndFlapsVanish) {
    const TriangleMesh mesh = sample::sphere(1.0, 2);
    TriangleSoup soup = soup_of(mesh);
    soup.triangles.push_back(soup.triangles[7]);
    auto rotated = soup.triangles[9];
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    soup.triangles.push_back(rotated);
    // Both sides of a flap that stands on an edge of the sphere.
    soup.points.emplace_back(0.0, 0.0, 2.0);
    const auto tip = static_cast<std::uint32_t>(soup.points.size() - 1);
    const auto [a, b, c] = soup.triangles[3];
    soup.triangles.push_back({a, b, tip});
    soup.triangles.push_back({b, a, tip});
    soup.triangles.push_back({a, a, b});
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(count(repaired.report, "duplicate triangles"), 2U);
    EXPECT_EQ(count(repaired.report,
                    "triangles that face each other in one place, as of flaps and of faces "
                    "between parts"),
              2U);
    EXPECT_EQ(count(repaired.report, "triangles with two corners in one point"), 1U);
    EXPECT_EQ(repaired.mesh.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(repaired.report.changed_fraction(), 0.0);
}

TEST(Repair, ABodyDrawnOnBothSidesIsKeptOnOne) {
    const TriangleMesh mesh = sample::sphere(1.0, 2);
    TriangleSoup soup = soup_of(sample::together(mesh, sample::inside_out(mesh)));
    for (const bool is_mixed : {false, true}) {
        if (is_mixed)  // each triangle and its back one after the other
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
                soup.triangles[2 * t] = mesh.triangles[t];
                soup.triangles[2 * t + 1] = {mesh.triangles[t][0], mesh.triangles[t][2],
                                             mesh.triangles[t][1]};
            }
        const RepairedMesh repaired = repair(soup, {.limit = 0.0});
        EXPECT_EQ(count(repaired.report, "triangles of a body that is drawn on both sides"),
                  mesh.triangles.size());
        EXPECT_EQ(repaired.report.findings.size(), 1U);
        EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(mesh), 1e-14);
    }
}

TEST(Repair, CracksOfRoundingAreClosed) {
    Random random(5, 0);
    const TriangleMesh mesh = sample::sphere(1.0, 3);
    TriangleSoup soup = apart(mesh);
    for (Vec3& point : soup.points) point += 2e-7 * random.direction();
    const RepairedMesh repaired = repair(soup);
    EXPECT_GT(count(repaired.report, "points at cracks"), 0U);
    EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    EXPECT_EQ(repaired.mesh.vertices.size(), mesh.vertices.size());
    EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(mesh), 1e-5);
}

TEST(Repair, HolesAreClosedWithinTheVolumeTheyPutAtStake) {
    const TriangleMesh mesh = sample::sphere(1.0, 4);
    TriangleSoup soup = soup_of(mesh);
    // A cap of the sphere: its triangles around one corner of the octahedron.
    std::erase_if(soup.triangles, [&mesh](const auto& t) {
        return mesh.vertices[t[0]].z() > 0.97 && mesh.vertices[t[1]].z() > 0.97 &&
               mesh.vertices[t[2]].z() > 0.97;
    });
    ASSERT_LT(soup.triangles.size(), mesh.triangles.size());
    const RepairedMesh repaired = repair(soup);
    const Finding* holes = find(repaired.report, "holes");
    ASSERT_NE(holes, nullptr);
    EXPECT_EQ(holes->count, 1U);
    EXPECT_GT(holes->place.z(), 0.9);
    EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    const double missing = enclosed_volume(mesh) - enclosed_volume(repaired.mesh);
    EXPECT_GT(missing, 0.0);
    EXPECT_LT(missing, holes->volume);
    EXPECT_NE(refusal(soup, {.limit = 1e-5}).find("holes: 1 at"), std::string::npos);
}

TEST(Repair, TrianglesAreSplitAtCornersOnTheirEdges) {
    // T-junctions: a triangle of a box is split in three along each of two edges, its neighbors are
    // not.
    TriangleMesh mesh = sample::box({0, 0, 0}, {3, 3, 3});
    const auto [a, b, c] = mesh.triangles[0];
    const auto along = [&mesh](std::uint32_t from, std::uint32_t to, double part) {
        mesh.vertices.emplace_back((1.0 - part) * mesh.vertices[from] + part * mesh.vertices[to]);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const std::uint32_t p = along(a, b, 0.3);
    const std::uint32_t q = along(a, b, 0.7);
    const std::uint32_t r = along(b, c, 0.4);
    mesh.triangles[0] = {a, p, c};
    mesh.triangles.insert(mesh.triangles.end(), {{p, q, c}, {q, b, r}, {q, r, c}});
    const RepairedMesh repaired = repair(soup_of(mesh), {.limit = 0.0});
    EXPECT_EQ(count(repaired.report, "corners on the edge of a neighbor"), 3U);
    EXPECT_EQ(repaired.report.findings.size(), 1U);
    EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    EXPECT_EQ(repaired.mesh.triangles.size(), 18U);
    EXPECT_NEAR(enclosed_volume(repaired.mesh), 27.0, 1e-13);
}

TEST(Repair, SheetsAndSingleTrianglesEncloseNothing) {
    const TriangleSoup triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}};
    EXPECT_NE(refusal(triangle).find("encloses no volume"), std::string::npos);
    TriangleSoup sheet;
    for (std::uint32_t i = 0; i < 10; ++i)
        for (std::uint32_t j = 0; j < 10; ++j) sheet.points.emplace_back(i, j, 0.0);
    for (std::uint32_t i = 0; i < 9; ++i)
        for (std::uint32_t j = 0; j < 9; ++j) {
            const std::uint32_t v = 10 * i + j;
            sheet.triangles.push_back({v, v + 10, v + 11});
            sheet.triangles.push_back({v, v + 11, v + 1});
        }
    EXPECT_NE(refusal(sheet).find("encloses no volume"), std::string::npos);
    const TriangleSoup point{{Vec3(1, 1, 1)}, {{0, 0, 0}}};
    EXPECT_NE(refusal(point).find("found no triangles with an area"), std::string::npos);
}

TEST(Repair, InsideOutIsTurned) {
    const TriangleMesh mesh = sample::sphere(1.0, 2);
    const RepairedMesh repaired = repair(soup_of(sample::inside_out(mesh)));
    EXPECT_EQ(count(repaired.report, "shells turned inside out"), 1U);
    EXPECT_EQ(repaired.report.changed_fraction(), 0.0);
    EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(mesh), 1e-14);
}

TEST(Repair, HollowsStayHollowHoweverTheWholeIsTurned) {
    const TriangleMesh hollow =
        sample::together(sample::sphere(2.0, 2), sample::inside_out(sample::sphere(1.0, 2)));
    for (const TriangleMesh& mesh : {hollow, sample::inside_out(hollow)}) {
        const RepairedMesh repaired = repair(soup_of(mesh));
        EXPECT_EQ(count(repaired.report, "hollows"), 1U);
        EXPECT_EQ(repaired.report.changed_fraction(), 0.0);
        EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(hollow), 1e-13);
    }
}

TEST(Repair, InnerShellFacingOutIsAQuestionOfTheLimit) {
    const TriangleMesh nested = sample::together(sample::sphere(2.0, 2), sample::sphere(1.0, 2));
    EXPECT_NE(refusal(soup_of(nested)).find("inner shells facing like the shell around them: 1"),
              std::string::npos);
    const RepairedMesh repaired = repair(soup_of(nested), {.limit = 0.2});
    EXPECT_NEAR(enclosed_volume(repaired.mesh), enclosed_volume(sample::sphere(2.0, 2)) * 7.0 / 8.0,
                1e-12);
    EXPECT_NEAR(repaired.report.changed_fraction(), 1.0 / 7.0, 1e-12);
}

TEST(Repair, OneBodyOrTheLargest) {
    const auto beside = [](double radius) {
        return sample::moved(sample::sphere(radius, 2), Mat3::Identity(), Vec3(5.0, 0.0, 0.0));
    };
    const TriangleMesh two = sample::together(beside(1.0), sample::sphere(2.0, 2));
    EXPECT_NE(refusal(soup_of(two)).find("separate bodies beside the largest: 1"),
              std::string::npos);
    const RepairedMesh largest = repair(soup_of(two), {.keep_largest = true});
    EXPECT_EQ(largest.mesh.triangles.size(), 128U);
    EXPECT_NEAR(enclosed_volume(largest.mesh), enclosed_volume(sample::sphere(2.0, 2)), 1e-13);
    // A crumb is left out, and said to be.
    const TriangleMesh crumb = sample::together(beside(0.1), sample::sphere(2.0, 2));
    const RepairedMesh repaired = repair(soup_of(crumb));
    EXPECT_EQ(count(repaired.report, "separate bodies"), 1U);
    EXPECT_NEAR(repaired.report.changed_fraction(), cube(0.1 / 2.0), 1e-10);
}

TEST(Repair, BodyInAHollowIsABodyOfItsOwn) {
    const TriangleMesh ball_in_shell = sample::together(
        sample::together(sample::sphere(3.0, 2), sample::inside_out(sample::sphere(2.0, 2))),
        sample::sphere(1.0, 2));
    EXPECT_NE(refusal(soup_of(ball_in_shell)).find("separate bodies beside the largest: 1"),
              std::string::npos);
    const RepairedMesh shell = repair(soup_of(ball_in_shell), {.keep_largest = true});
    EXPECT_NEAR(enclosed_volume(shell.mesh) / enclosed_volume(sample::sphere(1.0, 2)), 27.0 - 8.0,
                1e-11);
}

TEST(Repair, CubesThatShareAnEdgeAreTwoBodies) {
    const TriangleMesh cubes =
        sample::together(sample::box({0, 0, 0}, {1, 1, 1}), sample::box({1, 1, 0}, {2, 2, 1}));
    EXPECT_NE(refusal(soup_of(cubes)).find("separate bodies beside the largest: 1"),
              std::string::npos);
    const RepairedMesh one = repair(soup_of(cubes), {.keep_largest = true});
    EXPECT_TRUE(is_closed_and_oriented(one.mesh));
    EXPECT_NEAR(enclosed_volume(one.mesh), 1.0, 1e-15);
}

TEST(Repair, CrossingSurfacesAreRefusedWithAPlace) {
    const TriangleMesh crossing =
        sample::together(sample::box({-1, -1, -1}, {1, 1, 1}), sample::box({0, 0, 0}, {2, 2, 2}));
    EXPECT_NE(refusal(soup_of(crossing)).find("closed parts cross"), std::string::npos);
}

TEST(Repair, AllFaultsAreListedAtOnce) {
    TriangleMesh mesh =
        sample::together(sample::box({-1, -1, -1}, {1, 1, 1}), sample::box({0, 0, 0}, {2, 2, 2}));
    mesh.triangles.pop_back();
    const std::string message = refusal(soup_of(mesh), {.file_unit = 0.001});
    EXPECT_NE(message.find("holes: 1 at (2000"), std::string::npos) << message;
    EXPECT_NE(message.find("pairs of crossing triangles"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Repair, SmallCrossingsAreCutOut) {
    // One corner of a fine sphere pulled through the opposite of its ring.
    TriangleMesh mesh = sample::sphere(1.0, 4);
    const auto& [a, b, c] = mesh.triangles[100];
    mesh.vertices[a] += 1.6 * (mesh.vertices[b] - mesh.vertices[a]);
    const RepairedMesh repaired = repair(soup_of(mesh));
    EXPECT_GT(count(repaired.report, "pairs of crossing triangles"), 0U);
    EXPECT_TRUE(is_closed_and_oriented(repaired.mesh));
    EXPECT_NEAR(enclosed_volume(repaired.mesh) / enclosed_volume(sample::sphere(1.0, 4)), 1.0,
                1e-3);
}

TEST(Repair, RandomDamageGivesASurfaceOrARefusal) {
    int repaired_meshes = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Random random(seed, 0);
        TriangleSoup soup = soup_of(sample::torus(3.0, 1.0, 20, 10));
        const auto draw = [&random](std::size_t size) {
            return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(size)));
        };
        for (int blow = 0; blow < 3; ++blow) {
            const std::size_t t = draw(soup.triangles.size());
            const double kind = random.uniform(0.0, 5.0);
            if (kind < 1.0) soup.triangles.erase(soup.triangles.begin() + static_cast<int>(t));
            if (kind >= 1.0 && kind < 2.0) soup.triangles.push_back(soup.triangles[t]);
            if (kind >= 2.0 && kind < 3.0) std::swap(soup.triangles[t][0], soup.triangles[t][1]);
            if (kind >= 3.0 && kind < 4.0)
                soup.triangles[t][0] = static_cast<std::uint32_t>(draw(soup.points.size()));
            if (kind >= 4.0) soup.points[draw(soup.points.size())] = 3.0 * random.direction();
        }
        try {
            const RepairedMesh repaired = repair(soup);
            EXPECT_TRUE(is_closed_and_oriented(repaired.mesh)) << seed;
            EXPECT_GT(enclosed_volume(repaired.mesh), 0.0) << seed;
            EXPECT_LE(repaired.report.changed_fraction(), 0.01) << seed;
            ++repaired_meshes;
        } catch (const Error& error) {
            EXPECT_GT(std::string(error.what()).size(), 20U);
        }
    }
    EXPECT_GT(repaired_meshes, 10);
    EXPECT_LT(repaired_meshes, 60);
}

}  // namespace
}  // namespace dem::shapegen
