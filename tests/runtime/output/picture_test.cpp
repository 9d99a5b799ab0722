// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/picture.hpp"

#include "runtime/output/wall_lines.hpp"
#include "tests/support/sample_walls.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

/// A unit octahedron split until it is a sphere of radius 1 mm for the eye.
DisplayMesh ball() {
    constexpr double radius = 1e-3;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr int n = 64;
    for (int i = 0; i <= n; ++i) {
        for (int k = 0; k < 2 * n; ++k) {
            const double theta = pi * i / n;
            const double phi = pi * k / n;
            vertices.emplace_back(radius * std::sin(theta) * std::cos(phi),
                                  radius * std::sin(theta) * std::sin(phi),
                                  radius * std::cos(theta));
        }
    }
    const auto at = [](int i, int k) {
        return static_cast<std::uint32_t>(i * 2 * n + k % (2 * n));
    };
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < 2 * n; ++k) {
            triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return {vertices, triangles, 0.0};
}

bool is_background(const Image& image, std::size_t pixel) {
    return image.rgb[3 * pixel] == 255 && image.rgb[3 * pixel + 1] == 255 &&
           image.rgb[3 * pixel + 2] == 255;
}

TEST(Picture, ASphereCoversADiscOfItsRadius) {
    const DisplayMesh mesh = ball();
    const std::vector<PictureBody> bodies{{&mesh, Vec3::Zero(), Quat::Identity(), 0}};
    const Image image = render_picture(bodies, {}, 0.0, {});
    std::size_t covered = 0;
    for (std::size_t p = 0; p < image.width * image.height; ++p)
        covered += !is_background(image, p);
    // The longer side is the diameter and a margin of 3 % at each end.
    const double radius = static_cast<double>(image.width) / 2.12;
    EXPECT_NEAR(static_cast<double>(covered), pi * radius * radius, 0.01 * pi * radius * radius);
}

TEST(Picture, LightFallsFromAbove) {
    const DisplayMesh mesh = ball();
    const std::vector<PictureBody> bodies{{&mesh, Vec3::Zero(), Quat::Identity(), 0}};
    const Image image = render_picture(bodies, {}, 0.0, {});
    const auto brightness = [&](double height) {
        const auto row =
            static_cast<std::size_t>((1.0 - height) * static_cast<double>(image.height));
        return static_cast<int>(image.rgb[3 * (row * image.width + image.width / 2)]);
    };
    EXPECT_GT(brightness(0.8), brightness(0.2) + 50);
}

TEST(Picture, TheNearerBodyHidesTheOther) {
    const DisplayMesh mesh = ball();
    PictureView view;
    view.azimuth = 0.0;  // seen from +x
    view.elevation = 0.0;
    const std::vector<PictureBody> front{{&mesh, Vec3(5e-3, 0, 0), Quat::Identity(), 1}};
    const std::vector<PictureBody> both{{&mesh, Vec3(5e-3, 0, 0), Quat::Identity(), 1},
                                        {&mesh, Vec3(0, 0, 0), Quat::Identity(), 2}};
    EXPECT_EQ(render_picture(front, {}, 0.0, view).rgb, render_picture(both, {}, 0.0, view).rgb);
}

Wall plane_at(const Vec3& point, const Vec3& normal) {
    Wall wall;
    wall.shape = PlaneWall{};
    wall.position = point;
    wall.orientation = Quat::FromTwoVectors(Vec3::UnitZ(), normal);
    return wall;
}

// A box of planes 2 x 4 wide, open at the top, around bodies that touch none of them: a floor of
// 2 x 4 and four sides as high as the bodies reach; a plane far away is not drawn.
TEST(WallLines, OfABoxAreItsEdges) {
    std::vector<Wall> walls{
        plane_at(Vec3::Zero(), Vec3::UnitZ()),     plane_at({-1.0, 0.0, 0.0}, Vec3::UnitX()),
        plane_at({1.0, 0.0, 0.0}, -Vec3::UnitX()), plane_at({0.0, -2.0, 0.0}, Vec3::UnitY()),
        plane_at({0.0, 2.0, 0.0}, -Vec3::UnitY()), plane_at({0.0, 50.0, 0.0}, -Vec3::UnitY())};
    Aabb bodies;
    bodies.extend(Vec3(-0.7, -1.5, 0.2));
    bodies.extend(Vec3(0.8, 1.5, 3.0));
    double length = 0.0;
    for (const auto& [from, to] : wall_lines(walls, {0.0, bodies})) {
        for (const Vec3& x : {from, to}) {
            EXPECT_NEAR(std::abs(x.x()), 1.0, 1e-12);
            EXPECT_NEAR(std::abs(x.y()), 2.0, 1e-12);
            EXPECT_NEAR(std::abs(x.z() - 1.5), 1.5, 1e-12);
        }
        length += (to - from).norm();
    }
    EXPECT_NEAR(length, 2.0 * (2.0 + 4.0) + 4.0 * (2.0 + 3.0) + 4.0 * (4.0 + 3.0), 1e-9);
}

// Seen from the side a tube of 64 facets is two lines between its rims.
TEST(WallLines, OfASmoothMeshAreItsRimsAndItsSilhouette) {
    Wall tube;
    tube.shape = MeshWall{std::make_shared<const WallMesh>(sample::tube(2.0, 0.0, 5.0, 64).wall())};
    tube.position = {10.0, 0.0, 0.0};
    const Vec3 viewer = Vec3(0.02, -1.0, 0.0).normalized();
    const Aabb bodies{Vec3::Zero(), Vec3::Ones()};
    double at_rims = 0.0;
    std::vector<double> sides;
    for (const auto& [from, to] : wall_lines(std::span(&tube, 1), {0.0, bodies, viewer})) {
        if (from.z() == to.z()) {
            at_rims += (to - from).norm();
        } else {
            EXPECT_NEAR((to - from).norm(), 5.0, 1e-12);
            sides.push_back(from.x() - 10.0);
        }
    }
    EXPECT_NEAR(at_rims, 2.0 * 64.0 * 4.0 * std::sin(pi / 64.0), 1e-9);
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_NEAR(std::abs(sides[0]), 2.0, 0.02);
    EXPECT_NEAR(sides[0] + sides[1], 0.0, 1e-12);
}

TEST(Picture, APngHoldsItsSizeAndEndsWithItsTrailer) {
    const std::string png = encode_png({2, 3, std::vector<std::uint8_t>(18, 7)});
    EXPECT_EQ(png.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
    EXPECT_EQ(png[19], 2);
    EXPECT_EQ(png[23], 3);
    EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
}

}  // namespace
}  // namespace dem::runtime
