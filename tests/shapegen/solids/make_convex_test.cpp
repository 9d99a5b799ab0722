// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/solids/make_convex.hpp"

#include "common/error.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace dem::test {

using namespace shapegen;

namespace {

TEST(MakeConvex, RefusesDimensionsOfNoSolid) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(make_cuboid({1.0, 0.0, 1.0}, 0.0), Error);
    EXPECT_THROW(make_cuboid({1.0, 1.0, 1.0}, 0.5), Error);
    EXPECT_THROW(make_cylinder(1.0, -1.0, 0.0), Error);
    EXPECT_THROW(make_cone(1.0, 1.0, -0.1), Error);
    EXPECT_THROW(make_ellipsoid({1.0, nan, 1.0}), Error);
    EXPECT_THROW(rounded_hull(tetrahedron_corners(1.0), 0.3), Error);
}

TEST(MakeConvex, RoundingKeepsThePlanesOfTheFaces) {
    const std::vector<Vec3> points = random_points(30, {1.0, 0.7, 0.5}, 3);
    const ConvexPolyhedron sharp = hull_by_force(points);
    const ConvexSolid solid = rounded_hull(points, 0.01);
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

TEST(MakeConvex, MassPropertiesMeetClosedForms) {
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
    const MassProperties found = rounded_hull(corners, 0.0).mass_properties;
    EXPECT_LT((found.center_of_mass - Vec3(5, 6, 7)).norm(), 1e-13);
    Vec3 moments = found.principal_moments_per_density / 16.0;  // V/3 (b^2 + c^2), ...
    std::sort(moments.begin(), moments.end());
    EXPECT_LT((moments - Vec3(5, 10, 13)).norm(), 1e-12);
}

/// Moments from the distances to the surface along rays: another way to the same numbers, which
/// also holds the distance function to the shape.
TEST(MakeConvex, MassPropertiesMeetAnIntegrationOverRays) {
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

}  // namespace
}  // namespace dem::test
