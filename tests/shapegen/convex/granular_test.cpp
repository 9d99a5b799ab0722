// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/granular.hpp"

#include "common/error.hpp"
#include "common/state_hash.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using Kind = GranularOptions::Kind;
using Base = GranularOptions::Base;

std::uint64_t hash_of(const Grain& grain) {
    StateHash hash;
    hash.add_bytes(std::as_bytes(grain.solid.shape.vertices.span()));
    return hash.value();
}

/// The corners of the polyhedron before it was rounded, in the frame it was drawn in.
std::vector<Vec3> drawn_corners(const Grain& grain) {
    const MassProperties& mass = grain.solid.mass_properties;
    std::vector<Vec3> corners;
    for (const Vec3& v : grain.display_mesh.vertices) corners.emplace_back(mass.principal_axes * v);
    return corners;
}

/// Largest angle by which a corner could be moved before it meets the next, of a sphere [rad].
double smallest_angle(const std::vector<Vec3>& corners, const Vec3& center) {
    double least = pi;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 a = corners[i] - center;
            const Vec3 b = corners[j] - center;
            least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
    return least;
}

/// The center of the sphere through points, by least squares.
Vec3 sphere_center(const std::vector<Vec3>& points, double& radius) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Vec3& p : points) {
        const Eigen::Vector4d row(2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z(), 1.0);
        normal += row * row.transpose();
        right += row * p.squaredNorm();
    }
    const Eigen::Vector4d x = normal.ldlt().solve(right);
    radius = std::sqrt(x[3] + x.head<3>().squaredNorm());
    return x.head<3>();
}

TEST(Granular, SandHasFiveToTwentyCornersOnASphereThatKeepApart) {
    std::array<int, 21> seen{};
    GranularOptions options;
    options.size = 2.0;
    for (std::uint64_t index = 0; index < 250; ++index) {
        const Grain grain = make_grain(options, index);
        const std::vector<Vec3> corners = drawn_corners(grain);
        ASSERT_GE(corners.size(), 5U);
        ASSERT_LE(corners.size(), 20U);
        ++seen[corners.size()];
        EXPECT_LE(grain.solid.shape.vertices.size(), corners.size());
        double radius = 0.0;
        const Vec3 center = sphere_center(corners, radius);
        EXPECT_NEAR(radius, 1.0, 1e-6);
        // Half of the spacing that the most even arrangement would have at best.
        const double even =
            std::sqrt(8.0 * pi / std::sqrt(3.0) / static_cast<double>(corners.size()));
        EXPECT_GT(smallest_angle(corners, center), 0.35 * even) << index;
    }
    for (std::size_t n = 5; n <= 20; ++n) EXPECT_GT(seen[n], 3) << n;
}

TEST(Granular, EllipsoidalSandIsThreeTimesAsLongAsWideAtMost) {
    GranularOptions options;
    options.base = Base::ellipsoid;
    options.size = 2.0;
    double longest = 0.0;
    for (std::uint64_t index = 0; index < 100; ++index) {
        const std::vector<Vec3> corners = drawn_corners(make_grain(options, index));
        double length = 0.0;
        for (const Vec3& a : corners)
            for (const Vec3& b : corners) length = std::max(length, (a - b).norm());
        longest = std::max(longest, length);
        EXPECT_LE(length, 2.0 * std::cbrt(9.0) + 1e-12);
    }
    EXPECT_GT(longest, 1.9 * std::cbrt(9.0));
}

TEST(Granular, WoodchipsHaveTheDimensionsOfTheirRecipe) {
    GranularOptions options;
    options.kind = Kind::woodchips;
    options.size = 6.0;
    double shortest = 1e300;
    double longest = 0.0;
    for (std::uint64_t index = 0; index < 200; ++index) {
        const Grain grain = make_grain(options, index);
        const std::vector<Vec3> corners = drawn_corners(grain);
        ASSERT_EQ(corners.size(), 8U);
        double low = 1e300;
        double high = -1e300;
        for (const Vec3& p : corners) {
            low = std::min(low, p.z());
            high = std::max(high, p.z());
        }
        shortest = std::min(shortest, high - low);
        longest = std::max(longest, high - low);
        EXPECT_EQ(std::count_if(corners.begin(), corners.end(),
                                [&](const Vec3& p) { return p.z() > 0.5 * (low + high); }),
                  4);
    }
    EXPECT_GE(shortest, 5.0 - 1e-12);
    EXPECT_LT(shortest, 5.1);
    EXPECT_LE(longest, 7.0 + 1e-12);
    EXPECT_GT(longest, 6.9);
}

TEST(Granular, RoundingKeepsTheVolumeAndMovesTheSurfaceLittle) {
    for (const Kind kind : {Kind::sand, Kind::woodchips}) {
        GranularOptions options;
        options.kind = kind;
        options.size = 1.0;
        for (std::uint64_t index = 0; index < 100; ++index) {
            const Grain rounded = make_grain(options, index);
            EXPECT_NEAR(rounded.solid.rounding_loss, 0.0, 1e-12);
            EXPECT_NEAR(rounded.solid.shape.rounding,
                        0.01 * rounded.solid.shape.equivalent_diameter, 1e-12);
            EXPECT_GT(rounded.display_mesh.max_deviation, 0.0);
            EXPECT_LT(rounded.display_mesh.max_deviation,
                      0.1001 * rounded.solid.shape.equivalent_diameter)
                << index;
            // Its own mass properties, about its own center, in its own axes.
            const ConvexSolid again = with_mass_properties(rounded.solid.shape);
            EXPECT_LT(again.mass_properties.center_of_mass.norm(), 1e-12);
            EXPECT_NEAR(again.mass_properties.principal_moments_per_density.x() /
                            rounded.solid.mass_properties.principal_moments_per_density.x(),
                        1.0, 1e-9);
        }
    }
}

TEST(Granular, NoTwoAreAlikeAndEachDependsOnItsSeedAndIndexOnly) {
    std::set<std::uint64_t> hashes;
    GranularOptions options;
    for (const Kind kind : {Kind::sand, Kind::woodchips})
        for (const Base base : {Base::sphere, Base::ellipsoid})
            for (const std::uint64_t seed : {1U, 2U}) {
                if (kind == Kind::woodchips && base == Base::ellipsoid) continue;
                options.kind = kind;
                options.base = base;
                options.seed = seed;
                for (std::uint64_t index = 0; index < 200; ++index)
                    EXPECT_TRUE(hashes.insert(hash_of(make_grain(options, index))).second);
                EXPECT_TRUE(hashes.count(hash_of(make_grain(options, 17))));
            }
    EXPECT_EQ(hashes.size(), 1200U);
}

TEST(Granular, ARoundingThatNoGrainHasRoomForIsRefused) {
    GranularOptions options;
    options.rounding = Rounding{0.5, true};
    EXPECT_THROW(make_grain(options, 0), Error);
    options.rounding = Rounding{0.0, true};
    const Grain sharp = make_grain(options, 0);
    EXPECT_EQ(sharp.solid.shape.rounding, 0.0);
    EXPECT_LT(sharp.display_mesh.max_deviation, 1e-15);
}

}  // namespace
}  // namespace dem::shapegen
