// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/face_triangles.hpp"

#include "common/random.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/repair/repair.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using Outline = std::vector<Vec3>;

/// A face with the corners from `first` on, the other way round when `is_turned`.
PolygonSoup face(Outline outline, std::size_t first = 0, bool is_turned = false) {
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(first),
                outline.end());
    if (is_turned) std::reverse(outline.begin(), outline.end());
    PolygonSoup soup;
    soup.points = std::move(outline);
    for (std::uint32_t k = 0; k < soup.points.size(); ++k) soup.corners.push_back(k);
    soup.end_face();
    return soup;
}

struct Cut {
    TriangleSoup soup;
    RepairReport report;
    Vec3 area = Vec3::Zero();                                  ///< vector, of all triangles
    double absolute = 0.0;                                     ///< sum of their areas
    std::vector<std::array<std::array<double, 3>, 3>> places;  ///< sorted corners, to compare
};

Cut cut(PolygonSoup faces) {
    Cut result;
    result.soup = face_triangles(std::move(faces), result.report);
    for (const auto& [i, j, k] : result.soup.triangles) {
        const auto& p = result.soup.points;
        const Vec3 area = 0.5 * (p[j] - p[i]).cross(p[k] - p[i]);
        result.area += area;
        result.absolute += area.norm();
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3& x = p[std::array{i, j, k}[c]];
            corners[c] = {x.x(), x.y(), x.z()};
        }
        std::sort(corners.begin(), corners.end());
        result.places.push_back(corners);
    }
    std::sort(result.places.begin(), result.places.end());
    return result;
}

/// Every first corner and both ways round give triangles that fill the face once.
void expect_filled(const Outline& outline, const Vec3& area, std::size_t triangles) {
    const Cut first = cut(face(outline));
    EXPECT_EQ(first.soup.triangles.size(), triangles);
    for (std::size_t k = 0; k < outline.size(); ++k)
        for (const bool is_turned : {false, true}) {
            const Cut other = cut(face(outline, k, is_turned));
            const Vec3 expected = is_turned ? Vec3(-area) : area;
            EXPECT_LT((other.area - expected).norm(), 1e-12 * area.norm()) << k;
            EXPECT_NEAR(other.absolute / area.norm(), 1.0, 1e-12) << k;
            EXPECT_EQ(other.places, first.places) << k;
            EXPECT_TRUE(other.report.findings.empty()) << k;
        }
}

TEST(FaceTriangles, FillConcaveFacesWhateverTheirFirstCorner) {
    expect_filled({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 0, 3}, 4);
    expect_filled({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, {0, 0, 4}, 2);  // an arrow
    Outline star;
    for (int k = 0; k < 24; ++k) {
        const double r = k % 2 == 0 ? 1.0 : 0.3;
        star.emplace_back(r * std::cos(pi * k / 12.0), r * std::sin(pi * k / 12.0), 0.0);
    }
    expect_filled(star, {0, 0, 12 * 0.3 * std::sin(pi / 12.0)}, 22);
}

TEST(FaceTriangles, FillFacesThatLieAtAnAngle) {
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Outline comb{{0, 0, 0}, {7, 0, 0}};
    for (int k = 6; k >= 0; --k) comb.emplace_back(k + 0.5, k % 2 == 0 ? 3.0 : 1.0, 0.0);
    double area = 0.0;
    for (std::size_t k = 0; k < comb.size(); ++k) {
        const Vec3& a = comb[k];
        const Vec3& b = comb[(k + 1) % comb.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    for (Vec3& p : comb) p = turn * p;
    expect_filled(comb, turn * Vec3(0, 0, area), 7);
}

TEST(FaceTriangles, NeedNoTrianglesWithoutAreaForCornersOnStraightEdges) {
    const Cut square =
        cut(face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}));
    EXPECT_EQ(square.soup.triangles.size(), 4U);
    for (const auto& [i, j, k] : square.soup.triangles) {
        const auto& p = square.soup.points;
        EXPECT_GT((p[j] - p[i]).cross(p[k] - p[i]).z(), 0.5);
    }
    EXPECT_EQ(cut(face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}})).soup.triangles.size(), 2U);
}

TEST(FaceTriangles, AHoleMayBeBridgedToTheOutline) {
    expect_filled({{0, 0, 0},
                   {4, 0, 0},
                   {4, 4, 0},
                   {0, 4, 0},
                   {0, 0, 0},
                   {1, 1, 0},
                   {1, 3, 0},
                   {3, 3, 0},
                   {3, 1, 0},
                   {1, 1, 0}},
                  {0, 0, 12}, 8);
}

TEST(FaceTriangles, TheShorterDiagonalCutsFourCorners) {
    const Cut kite = cut(face({{0, 0, 0}, {5, 1, 0}, {10, 0, 0}, {5, -1, 0}}, 1));
    const auto has_both_ends = [](const auto& t) {
        return std::find(t.begin(), t.end(), std::array{5.0, -1.0, 0.0}) != t.end() &&
               std::find(t.begin(), t.end(), std::array{5.0, 1.0, 0.0}) != t.end();
    };
    EXPECT_TRUE(std::all_of(kite.places.begin(), kite.places.end(), has_both_ends));
}

TEST(FaceTriangles, CornersNamedTwiceAndFacesWithoutAreaDoNoHarm) {
    const Cut repeated = cut(face({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(repeated.soup.triangles.size(), 1U);
    ASSERT_EQ(repeated.report.findings.size(), 1U);
    EXPECT_EQ(repeated.report.findings[0].what, "faces that name a corner twice");
    EXPECT_TRUE(cut(face({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}})).soup.triangles.empty());
    const Cut line = cut(face({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}));
    EXPECT_EQ(line.absolute, 0.0);
    EXPECT_TRUE(line.report.findings.empty());
}

TEST(FaceTriangles, AnOutlineThatCrossesItselfIsReported) {
    for (const Outline& outline :
         {Outline{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
          Outline{{0, 0, 0}, {2, 2, 0}, {4, 0, 0}, {4, 2, 0}, {0, 1, 0}}}) {
        const Cut crossing = cut(face(outline));
        ASSERT_EQ(crossing.report.findings.size(), 1U);
        EXPECT_EQ(crossing.report.findings[0].what, "faces whose outline crosses itself");
    }
}

TEST(FaceTriangles, RandomStarShapedFacesAreFilled) {
    Random random(11, 0);
    for (int i = 0; i < 200; ++i) {
        const int n = 4 + static_cast<int>(random.uniform(0.0, 30.0));
        Outline outline;
        double area = 0.0;
        for (int k = 0; k < n; ++k) {
            const double r = random.uniform(0.2, 1.0);
            const double angle = 2.0 * pi * (k + random.uniform(0.0, 0.5)) / n;
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
        }
        for (std::size_t k = 0; k < outline.size(); ++k)
            area += 0.5 * outline[k].cross(outline[(k + 1) % outline.size()]).z();
        const Cut filled = cut(face(outline, static_cast<std::size_t>(n) / 2));
        EXPECT_NEAR(filled.absolute, area, 1e-13);
        EXPECT_EQ(filled.soup.triangles.size(), static_cast<std::size_t>(n) - 2);
    }
}

}  // namespace
}  // namespace dem::shapegen
