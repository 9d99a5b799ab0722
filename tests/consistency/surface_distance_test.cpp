// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/shapes/surface_distance.hpp"

#include "common/random.hpp"
#include "shapegen/pipeline/cook.hpp"
#include "shapegen/pipeline/cook_convex.hpp"
#include "shapegen/profile/profile_file.hpp"
#include "shapegen/revolution/mass_properties.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// Nearest surface points and inside or outside of every kind, each against a second method.
namespace dem::shapegen {
namespace {

const std::filesystem::path data = std::string(DEM_SOURCE_DIR) + "/data";

Vec3 random_point(double radius, Random& random) {
    return radius * std::cbrt(random.uniform()) * random.direction();
}

/// The nearest surface point that the answer means lies on the surface: one side is in, one out.
void expect_surface_point(const ParticleTemplate& shape, const Vec3& x, const SurfaceDistance& d,
                          double room) {
    ASSERT_NEAR(d.normal.norm(), 1.0, 1e-12);
    const Vec3 p = x - d.distance * d.normal;
    ASSERT_TRUE(is_inside(shape, p - room * d.normal));
    ASSERT_FALSE(is_inside(shape, p + room * d.normal));
}

TEST(SurfaceDistance, OfRevolutionIsThatOfTheProfile) {
    for (const char* name : {"candy", "tablet", "peanut", "red_blood_cell", "disc"}) {
        SCOPED_TRACE(name);
        const Profile profile =
            read_profile((data / "profiles" / name).string() + ".profile").profile;
        const ParticleTemplate shape = cook(profile, name, {});
        const Profile exact =
            profile.translated(-revolution_mass(profile).mass_properties.center_of_mass.z());
        const double l = exact.major_axis_length();
        const std::map<std::string, double> certificate(shape.certificate.begin(),
                                                        shape.certificate.end());
        const double stated = certificate.at("sdf_error_max") * l;
        Random random(1, 0);
        for (int n = 0; n < 4000; ++n) {
            const Vec3 x = random_point(n % 2 == 0 ? 1.1 * shape.bounding_radius : 5.0 * l, random);
            const SurfaceDistance d = surface_distance(shape, x);
            const double expected =
                exact.signed_distance({std::sqrt(square(x.x()) + square(x.y())), x.z()});
            ASSERT_NEAR(d.distance, expected, std::max(1.5 * stated, 6e-5 * l)) << x.transpose();
            if (std::abs(expected) > 1.5 * stated) {
                ASSERT_EQ(is_inside(shape, x), expected < 0.0);
            }
        }
    }
}

TEST(SurfaceDistance, OfConvexShapesIsThatOfTheMeshOfTheirSurface) {
    std::vector<ParticleTemplate> shapes;
    for (const auto& file : std::filesystem::directory_iterator(data / "convex"))
        shapes.push_back(cook_convex(file.path(), {}, {}).shape);
    ASSERT_GE(shapes.size(), 9U);
    for (const ParticleTemplate& shape : shapes) {
        SCOPED_TRACE(shape.name);
        const DisplayMesh& display = shape.display_mesh;
        const SurfaceQuery mesh({{display.vertices.begin(), display.vertices.end()},
                                 {display.triangles.begin(), display.triangles.end()}});
        const double room = display.max_deviation + 1e-9 * shape.bounding_radius;
        Random random(2, 0);
        for (int n = 0; n < 3000; ++n) {
            const Vec3 x = random_point(1.5 * shape.bounding_radius, random);
            const SurfaceDistance d = surface_distance(shape, x);
            ASSERT_NEAR(d.distance, mesh.signed_distance(x), room);
            if (std::abs(d.distance) > room) {
                ASSERT_EQ(is_inside(shape, x), mesh.is_inside(x));
            }
            expect_surface_point(shape, x, d, 1e-9 * shape.bounding_radius);
        }
    }
}

std::vector<ClumpSphere> random_spheres(std::size_t count, std::uint64_t seed) {
    Random random(seed, count);
    std::vector<ClumpSphere> spheres;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 c = random_point(1.0, random);
        spheres.push_back({c.x(), c.y(), c.z(), random.uniform(0.1, 0.6), 1.0});
    }
    return spheres;
}

/// Points all over the surface of the union.
std::vector<Vec3> surface_points(const std::vector<ClumpSphere>& spheres, Random& random) {
    std::vector<Vec3> points;
    for (const ClumpSphere& s : spheres) {
        for (int n = 0; n < 4000; ++n) {
            const Vec3 p = s.center() + s.radius * random.direction();
            if (std::none_of(spheres.begin(), spheres.end(), [&](const ClumpSphere& other) {
                    return (p - other.center()).norm() < (1.0 - 1e-12) * other.radius;
                }))
                points.push_back(p);
        }
    }
    return points;
}

TEST(SurfaceDistance, OfClumpsIsThatOfPointsAllOverTheUnion) {
    Random random(3, 0);
    for (const std::size_t count : {1U, 2U, 3U, 8U, 40U}) {
        SCOPED_TRACE(count);
        const std::vector<ClumpSphere> spheres = random_spheres(count, 7);
        ParticleTemplate shape;
        shape.bounding_radius = 2.0;
        shape.shape = make_clump(spheres);
        const std::vector<Vec3> surface = surface_points(spheres, random);
        int inside = 0;
        for (int n = 0; n < 300; ++n) {
            const Vec3 x = random_point(1.6, random);
            const SurfaceDistance d = surface_distance(shape, x);
            double nearest = 1e30;
            for (const Vec3& p : surface) nearest = std::min(nearest, (p - x).norm());
            // Points of a sphere lie 0.03 radii apart, at a crease or corner a little farther away.
            ASSERT_LE(std::abs(d.distance), nearest * (1.0 + 1e-12));
            ASSERT_NEAR(std::abs(d.distance), nearest, 0.05);
            ASSERT_EQ(d.distance <= 0.0, is_inside(shape, x));
            const Vec3 p = x - d.distance * d.normal;
            double deepest = -1.0;
            for (const ClumpSphere& s : spheres)
                deepest = std::max(deepest, s.radius - (p - s.center()).norm());
            ASSERT_NEAR(deepest, 0.0, 1e-9);
            inside += d.distance < 0.0 ? 1 : 0;
        }
        EXPECT_GT(inside, 2);
    }
}

TEST(SurfaceDistance, InsideOfAClumpEndsInCornersOfThreeSpheres) {
    // Three spheres around the origin: the way out of it leads along the axis to where all meet.
    std::vector<ClumpSphere> spheres;
    for (int k = 0; k < 3; ++k)
        spheres.push_back(
            {std::cos(2.0 * pi * k / 3.0), std::sin(2.0 * pi * k / 3.0), 0.0, 1.25, 1.0});
    const SurfaceDistance d = surface_distance(make_clump(spheres), Vec3(0.0, 0.0, 0.1));
    EXPECT_NEAR(d.distance, 0.1 - 0.75, 1e-12);
    EXPECT_NEAR((d.normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(SurfaceDistance, OfASphere) {
    ParticleTemplate shape;
    shape.bounding_radius = 2.0;
    shape.shape = Sphere{2.0};
    const SurfaceDistance d = surface_distance(shape, Vec3(0.0, 3.0, 4.0));
    EXPECT_NEAR(d.distance, 3.0, 1e-15);
    EXPECT_NEAR((d.normal - Vec3(0.0, 0.6, 0.8)).norm(), 0.0, 1e-15);
    EXPECT_EQ(surface_distance(shape, Vec3::Zero()).distance, -2.0);
    EXPECT_TRUE(is_inside(shape, Vec3(2.0, 0.0, 0.0)));
    EXPECT_FALSE(is_inside(shape, Vec3(2.0 + 1e-12, 0.0, 0.0)));
}

TEST(SurfaceDistance, PointsInsideMakeUpTheVolume) {
    std::vector<ParticleTemplate> shapes{
        cook(read_profile((data / "profiles/peanut.profile").string()).profile, "peanut", {}),
        cook_convex(data / "convex/cone.convex", {}, {}).shape,
        cook_convex(data / "convex/octahedron.convex", {}, {}).shape};
    for (const ParticleTemplate& shape : shapes) {
        SCOPED_TRACE(shape.name);
        Random random(4, 0);
        constexpr int count = 100'000;
        const double r = shape.bounding_radius;
        int inside = 0;
        for (int n = 0; n < count; ++n) inside += is_inside(shape, random_point(r, random)) ? 1 : 0;
        const double share = shape.mass_properties.volume / (4.0 / 3.0 * pi * cube(r));
        EXPECT_NEAR(static_cast<double>(inside) / count, share,
                    4.0 * std::sqrt(share * (1.0 - share) / count));
    }
}

}  // namespace
}  // namespace dem::shapegen
