// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/shapes/convex_moments.hpp"
#include "tests/common/shapes/sample_convex.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace dem::test {
namespace {

TEST(ConvexHull, OfACubeWithPointsOnAndInItHasItsCornersAndWholeFaces) {
    Random random(1, 1);
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) points.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    points.push_back(points[3]);
    for (int k = 0; k < 300; ++k) {
        Vec3 p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        if (k % 3 == 0) p[k % 9 / 3] = 1.0;  // on a face
        points.push_back(p);
    }
    const ConvexPolyhedron hull = convex_hull(points);
    EXPECT_EQ(hull.vertices.size(), 8U);
    ASSERT_EQ(hull.faces.size(), 6U);
    for (const auto& face : hull.faces) EXPECT_EQ(face.size(), 4U);
}

TEST(ConvexHull, HoldsEveryPointForManyShapesOfCloud) {
    for (const std::size_t count : {4U, 5U, 12U, 100U, 2000U}) {
        for (const Vec3& axes : {Vec3(1, 1, 1), Vec3(1000, 1, 1), Vec3(1, 1, 1e-3)}) {
            const std::vector<Vec3> points = random_points(count, axes, 7);
            const ConvexPolyhedron hull = convex_hull(points);
            EXPECT_EQ(hull.vertices.size(), count);  // all lie on an ellipsoid
            for (std::size_t f = 0; f < hull.faces.size(); ++f) {
                const Vec3 n = hull.normal(f);
                const double offset = hull.offset(f, n);
                for (const Vec3& p : points) ASSERT_LE(n.dot(p), offset + 3e-9 * axes.norm());
            }
        }
    }
}

TEST(ConvexHull, RefusesWhatIsNoSolid) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}};
    const std::vector<Vec3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const std::vector<Vec3> point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const std::vector<Vec3> broken{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, nan, 1}};
    for (const auto& points : {three, flat, line, point, broken})
        EXPECT_THROW(convex_hull(points), Error);
    EXPECT_THROW(make_cuboid({1.0, 0.0, 1.0}, 0.0), Error);
    EXPECT_THROW(make_cuboid({1.0, 1.0, 1.0}, 0.5), Error);
    EXPECT_THROW(make_cylinder(1.0, -1.0, 0.0), Error);
    EXPECT_THROW(make_cone(1.0, 1.0, -0.1), Error);
    EXPECT_THROW(make_ellipsoid({1.0, nan, 1.0}), Error);
    EXPECT_THROW(make_convex_polyhedron(tetrahedron_corners(1.0), 0.3), Error);
}

TEST(ConvexShape, RoundingKeepsThePlanesOfTheFaces) {
    const std::vector<Vec3> points = random_points(30, {1.0, 0.7, 0.5}, 3);
    const ConvexPolyhedron sharp = convex_hull(points);
    const ConvexSolid solid = make_convex_polyhedron(points, 0.01);
    const MassProperties& mass = solid.mass_properties;
    for (const ConvexShape::Plane& plane : solid.shape.planes) {
        const Vec3 n = mass.principal_axes * plane.normal;
        double offset = -1e300;
        for (const Vec3& v : sharp.vertices) offset = std::max(offset, n.dot(v));
        EXPECT_NEAR(extent(solid.shape, plane.normal) + n.dot(mass.center_of_mass), offset, 1e-9);
    }
    EXPECT_GT(solid.rounding_loss, 0.0);
    EXPECT_LT(solid.rounding_loss, 0.01);
}

TEST(ConvexShape, MassPropertiesMeetClosedForms) {
    const double r = 0.1;
    const ConvexSolid box = make_cuboid({1.2, 1.4, 1.8}, r);
    const double a = 1.0, b = 1.2, c = 1.6;
    EXPECT_NEAR(box.mass_properties.volume,
                a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) +
                    4.0 / 3.0 * pi * r * r * r,
                1e-13);
    const ConvexSolid ball = make_convex_sphere(0.5);
    EXPECT_NEAR(ball.mass_properties.principal_moments_per_density.x(),
                8.0 / 15.0 * pi * std::pow(0.5, 5), 1e-15);
    EXPECT_NEAR(ball.mean_squared_surface_distance, 0.25, 1e-15);
    const double e = std::sqrt(1.0 - 1.0 / 9.0);
    EXPECT_NEAR(make_ellipsoid({1.0, 1.0, 3.0}).surface_area,
                2.0 * pi * (1.0 + 3.0 / e * std::asin(e)), 1e-12);
    EXPECT_NEAR(make_ellipsoid({3.0, 2.0, 1.0}).mass_properties.principal_moments_per_density.x(),
                8.0 * pi, 1e-12);
    const ConvexSolid capsule = make_capsule(0.5, 3.0);
    EXPECT_NEAR(capsule.mass_properties.volume, pi * 0.25 * 2.0 + pi / 6.0, 1e-13);
    EXPECT_NEAR(capsule.mass_properties.principal_moments_per_density.z(),
                pi * std::pow(0.5, 4) * (0.5 * 2.0 + 8.0 / 15.0 * 0.5), 1e-13);
    const ConvexSolid cone = make_cone(0.5, 2.0, 0.0);
    EXPECT_NEAR(cone.mass_properties.center_of_mass.z(), 0.5, 1e-14);
    EXPECT_NEAR(cone.mass_properties.principal_moments_per_density.z(),
                0.3 * cone.mass_properties.volume * 0.25, 1e-14);
    EXPECT_LT(make_cylinder(1.0, 2.0, 0.0).rounding_loss, 1e-14);
    // Axes and center of a turned and shifted solid are found again.
    std::vector<Vec3> corners;
    const Quat turn = Quat(0.8, 0.3, -0.4, 0.2).normalized();
    for (int k = 0; k < 8; ++k) {
        corners.emplace_back(turn * Vec3(k & 1 ? 1 : -1, k & 2 ? 2 : -2, k & 4 ? 3 : -3) +
                             Vec3(5, 6, 7));
    }
    const MassProperties found = make_convex_polyhedron(corners, 0.0).mass_properties;
    EXPECT_LT((found.center_of_mass - Vec3(5, 6, 7)).norm(), 1e-13);
    Vec3 moments = found.principal_moments_per_density / 16.0;  // V/3 (b^2 + c^2), ...
    std::sort(moments.begin(), moments.end());
    EXPECT_LT((moments - Vec3(5, 10, 13)).norm(), 1e-12);
}

/// Moments from the distances to the surface along rays: another way to the same numbers, which
/// also holds the distance function to the shape.
TEST(ConvexShape, MassPropertiesMeetAnIntegrationOverRays) {
    for (const auto& [name, solid] : convex_solids()) {
        constexpr int rings = 60;
        double volume = 0.0;
        Vec3 first = Vec3::Zero();
        Vec3 second = Vec3::Zero();
        for (int i = 0; i < rings; ++i) {
            for (int k = 0; k < 2 * rings; ++k) {
                const double theta = (i + 0.5) * pi / rings;
                const double phi = (k + 0.5) * pi / rings;
                const double s = std::sin(theta);
                const Vec3 u(s * std::cos(phi), s * std::sin(phi), std::cos(theta));
                double inside = 0.0;
                for (int n = 0; n < 100; ++n) {
                    const double gap = -surface_distance(solid.shape, inside * u).distance;
                    inside += gap;
                    if (gap < 1e-6) break;
                }
                const double weight = s * square(pi / rings);
                volume += weight * cube(inside) / 3.0;
                first += weight * std::pow(inside, 4) / 4.0 * u;
                second += weight * std::pow(inside, 5) / 5.0 * u.cwiseProduct(u);
            }
        }
        const MassProperties& mass = solid.mass_properties;
        const double size = solid.shape.bounding_radius;
        EXPECT_NEAR(volume / mass.volume, 1.0, 4e-3) << name;
        EXPECT_LT(first.norm(), 5e-3 * mass.volume * size) << name;
        for (int k = 0; k < 3; ++k) {
            const double moment = second.sum() - second[k];
            EXPECT_NEAR(moment / mass.principal_moments_per_density[k], 1.0, 8e-3) << name;
        }
    }
}

TEST(ConvexShape, SurfaceIsTheGrowthOfTheVolume) {
    for (auto [name, solid] : convex_solids()) {
        ConvexShape shape = solid.shape;
        const double h = 1e-4;
        const ConvexMoments at = convex_moments(shape);
        shape.rounding += h;
        const ConvexMoments more = convex_moments(shape);
        shape.rounding -= 2.0 * h;
        if (shape.rounding < 0.0) continue;
        const ConvexMoments less = convex_moments(shape);
        EXPECT_NEAR((more.volume - less.volume) / (2.0 * h) / at.area, 1.0, 1e-6) << name;
        EXPECT_NEAR((more.second - less.second).trace() / (2.0 * h) / at.surface_second, 1.0, 1e-6)
            << name;
    }
}

TEST(ConvexShape, TheNearestSurfacePointIsOnTheSurfaceAndNoneIsNearer) {
    for (const auto& [name, solid] : convex_solids()) {
        const ConvexShape& shape = solid.shape;
        Random random(5, 1);
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 x = random.uniform(0.01, 1.6) * shape.bounding_radius * random.direction();
            const SurfaceDistance d = surface_distance(shape, x);
            ASSERT_NEAR(d.normal.norm(), 1.0, 1e-12) << name;
            const Vec3 p = x - d.distance * d.normal;
            // All of the body is on one side of the plane through the nearest point.
            ASSERT_NEAR(d.normal.dot(p), extent(shape, d.normal), 1e-10) << name;
            if (d.distance > 0.0) continue;
            for (int k = 0; k < 100; ++k) {
                const Vec3 u = random.direction();
                ASSERT_LE(u.dot(x) - d.distance, extent(shape, u) + 1e-10) << name;
            }
        }
    }
}

TEST(ConvexShape, ClimbingFindsTheFarthestVertexFromEverywhere) {
    const ConvexSolid solid = random_polyhedron(400, 2, 0.0);
    Random random(9, 9);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 u = random.direction();
        double most = -1e300;
        for (const Vec3& v : solid.shape.vertices) most = std::max(most, u.dot(v));
        const auto start = static_cast<std::uint32_t>(random.uniform() * 400.0);
        ASSERT_EQ(core_support(solid.shape, u, start).position.dot(u), most);
    }
    EXPECT_TRUE(is_closed_hull(solid.shape));
}

}  // namespace
}  // namespace dem::test
