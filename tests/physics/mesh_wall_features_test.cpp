// SPDX-License-Identifier: BSD-3-Clause
// What a ball feels of faces, edges, corners and rims.
#include "runtime/contact/meshes/ball_touch.hpp"
#include "tests/physics/mesh_wall_host.hpp"

#include <gtest/gtest.h>

namespace dem::test::mesh_walls {
namespace {

TEST(MeshWallSphere, AHundredTrianglesOfOnePlaneFeelAsOne) {
    const MeshWall plate = mesh_wall(sample::plate({-0.1, -0.02}, {0.1, 0.02}, 25, 2));
    const double height = 0.99 * radius;
    double least = infinite;
    double most = 0.0;
    // Along a row of corners, along a row of diagonals, across everything.
    for (const auto& [y0, y1] :
         {std::pair(0.0, 0.0), std::pair(0.011, 0.011), std::pair(-0.017, 0.016)}) {
        along(plate, {-0.09, y0, height}, {0.09, y1, height}, 20000, [&](const PairContact& c) {
            EXPECT_EQ(c.points, 1U);
            least = std::min(least, c.force.z());
            most = std::max(most, c.force.z());
            EXPECT_LT(std::hypot(c.force.x(), c.force.y()), 1e-9 * c.force.z());
        });
    }
    EXPECT_LT(most / least - 1.0, 1e-9);
}

// Of a clump a sphere may be so small that the body hardly overlaps while its center goes through.
TEST(MeshWallSphere, ACenterThatHasGoneThroughByMoreThanHalfItsRadiusIsLost) {
    const MeshWall plate = mesh_wall(sample::plate({-0.1, -0.1}, {0.1, 0.1}, 1, 1));
    MeshHistory front;
    front.used = 1;
    front.contacts[0].sides.fill(MeshHistory::none);
    front.contacts[0].sides[0] = 0;
    const auto is_lost = [&](double height, const MeshHistory& history) {
        TouchedSides sides;
        BallTouches touches(*plate.mesh, {0.01, -0.03, height * radius}, radius, history, sides);
        touches.add(0);
        touches.add(1);
        return touches.is_lost();
    };
    EXPECT_FALSE(is_lost(0.9, front));
    EXPECT_FALSE(is_lost(-0.4, front)) << "it is pushed back";
    EXPECT_TRUE(is_lost(-0.6, front));
    EXPECT_FALSE(is_lost(-0.95, front)) << "a first touch of the back";
    EXPECT_FALSE(is_lost(-0.6, MeshHistory{}));
}

// So that friction goes on where a ball passes it from above to below.
TEST(MeshWallSphere, TheFrontAndTheBackMeetInOneContactAtRimsAndTheirCorners) {
    const MeshWall plate = mesh_wall(sample::plate({-0.1, -0.1}, {0.1, 0.1}, 1, 1));
    const auto are_one = [&](const Vec3& center) {
        TouchedSides sides;
        BallTouches touches(*plate.mesh, center, radius, {}, sides);
        touches.add(0);
        touches.add(1);
        return sides.contact_of(sides.number_of(0)) == sides.contact_of(sides.number_of(1));
    };
    EXPECT_TRUE(are_one({0.1 + 0.9 * radius, 0.02, 0.1 * radius})) << "at a rim";
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            const Vec3 corner(0.1 * x, 0.1 * y, 0.0);
            EXPECT_TRUE(are_one(corner + 0.6 * radius * Vec3(x, y, 0.1))) << x << ' ' << y;
        }
    }
    EXPECT_FALSE(are_one({0.01, 0.02, 0.9 * radius})) << "over a face";
}

TEST(MeshWallSphere, AValleyOfTwoDegreesIsCrossedWithoutAJumpInForce) {
    const MeshWall wall = mesh_wall(sample::valley(2.0 * pi / 180.0, 0.05, 0.1));
    const auto largest_jump = [&](int steps) {
        Vec3 before = Vec3::Zero();
        double jump = 0.0;
        double force = 0.0;
        along(wall, {-0.001, 0.003, 0.995 * radius}, {0.001, 0.003, 0.995 * radius}, steps,
              [&](const PairContact& c) {
                  EXPECT_EQ(c.points, 1U);
                  if (before.norm() > 0.0) jump = std::max(jump, (c.force - before).norm());
                  before = c.force;
                  force = std::max(force, c.force.norm());
              });
        return jump / force;
    };
    const double coarse = largest_jump(2000);
    const double fine = largest_jump(20000);
    EXPECT_LT(fine, 0.11 * coarse);
    EXPECT_LT(fine, 1e-3);
}

TEST(MeshWallSphere, SlidingOverValleysAndRidgesKeepsTheEnergy) {
    const ContactLaw law = elastic_law();
    for (const double degrees : {2.0, -2.0, 15.0, 40.0, 90.0}) {
        MeshHost<Sphere> mesh{{radius}, mesh_wall(sample::valley(degrees * pi / 180.0, 0.05, 0.1))};
        TwoBodies a;
        a.i.inverse = solid_sphere(1377.0, radius);
        const double slope = 0.5 * degrees * pi / 180.0;
        a.i.position = {-0.01, 0.003, 0.01 * std::tan(slope) + radius / std::cos(slope)};
        a.i.velocity = 0.3 * Vec3(std::cos(slope), 0.0, -std::sin(slope));
        a.acceleration = {0.0, 0.0, -9.81};
        const auto energy = [&] {
            return a.mechanical_energy() + 9.81 * a.i.position.z() / a.i.inverse.mass;
        };
        const double start = energy();
        const double scale = a.kinetic_energy();
        double worst = 0.0;
        for (int n = 0; n < 60000; ++n) {
            a.step(1e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
            worst = std::max(worst, std::abs(energy() - start) / scale);
        }
        RecordProperty("worst_" + std::to_string(degrees), std::to_string(worst));
        // Into the steeper ones it falls: while an impact lasts, steps show in the energy.
        EXPECT_LT(worst, std::abs(degrees) < 3.0 ? 1e-6 : 1e-4) << degrees;
    }
}

// Facets end at the rim: no plane reaches beyond it, and no ball that is away from all triangles
// touches.
TEST(MeshWallSphere, NothingIsFeltBeyondTheRimOfAFunnel) {
    sample::Surface funnel;
    const int facets = 48;
    const auto at = [&](int k, double r, double z) {
        const auto [sine, cosine] = math::sin_cos(2.0 * pi * (k % facets) / facets);
        return Vec3(r * cosine, r * sine, z);
    };
    for (int k = 0; k < facets; ++k)
        funnel.add_quad(at(k, 0.012, 0.0), at(k + 1, 0.012, 0.0), at(k + 1, 0.035, 0.04),
                        at(k, 0.035, 0.04));
    const MeshWall wall = mesh_wall(funnel);
    const ContactLaw law = elastic_law();
    Random random(12, 0);
    int touching = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3 x(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02),
                     random.uniform(-0.006, 0.004));
        MeshHost<Sphere> host{{radius}, wall};
        PairState pair{};
        pair.displacement = -x;
        pair.i.inverse_inertia = solid_sphere(1377.0, radius);
        const PairContact c = host(pair, law, 1e-6);
        const double overlap = radius - distance_within(*wall.mesh, x, 1.0);
        EXPECT_LE(c.overlap, std::max(0.0, overlap) + 0.02 * radius);
        if (overlap > 0.0) {
            EXPECT_GE(c.overlap, overlap * (1.0 - 1e-9));
            ++touching;
        }
    }
    EXPECT_GT(touching, 1000);
}

TEST(MeshWallSphere, ASheetIsTouchedFromBothSides) {
    const MeshWall plate = mesh_wall(sample::plate({-0.05, -0.05}, {0.05, 0.05}, 5, 5));
    for (const double side : {1.0, -1.0})
        along(plate, {0.0, 0.0, 0.99 * side * radius}, {0.01, 0.0, 0.99 * side * radius}, 10,
              [&](const PairContact& c) { EXPECT_GT(side * c.force.z(), 0.0); });
}

TEST(MeshWallSphere, ACenterThatHasComeThroughIsPushedBackToItsSide) {
    const MeshWall plate = mesh_wall(sample::plate({-0.05, -0.05}, {0.05, 0.05}, 5, 5));
    double before = 0.0;
    along(plate, {0.0, 0.0, radius}, {0.0, 0.0, -0.4 * radius}, 1000, [&](const PairContact& c) {
        if (!c.touches()) return;
        EXPECT_GT(c.force.z(), before);
        before = c.force.z();
    });
}

// Friction that holds a sphere over a ridge is not lost where one face ends and the other begins.
TEST(MeshWallSphere, TheTangentialSpringGoesOnOverABulgingEdge) {
    const MeshWall ridge = mesh_wall(sample::valley(-90.0 * pi / 180.0, 0.05, 0.1));
    ContactLaw law = elastic_law();
    law.friction = 10.0;
    MeshHost<Sphere> host{{radius}, ridge};
    Vec3 before = Vec3::Zero();
    double largest = 0.0;
    // Around the edge at a constant overlap, dragged along it.
    for (int n = 0; n <= 4000; ++n) {
        const double angle = (-60.0 + 120.0 * n / 4000) * pi / 180.0;
        PairState pair{};
        const double reach = 0.995 * radius;
        const double slope = 45.0 * pi / 180.0;
        Vec3 center(reach * std::sin(angle), 0.0, reach * std::cos(angle));
        if (std::abs(angle) > slope) {
            const double away = reach * (std::abs(angle) - slope);
            const double side = angle > 0.0 ? 1.0 : -1.0;
            center = Vec3(side * (reach * std::sin(slope) + away * std::cos(slope)), 0.0,
                          reach * std::cos(slope) - away * std::sin(slope));
        }
        pair.displacement = -center;
        pair.i.inverse_inertia = solid_sphere(1377.0, radius);
        pair.i.velocity = {0.0, n < 1000 ? 1e-3 : 0.0, 0.0};
        host.travel += 1e-5;
        const PairContact c = host(pair, law, 1e-5);
        ASSERT_EQ(c.points, 1U);
        const Vec3 friction(0.0, c.force.y(), 0.0);
        if (n > 1001) largest = std::max(largest, (friction - before).norm() / before.norm());
        before = friction;
    }
    EXPECT_GT(before.norm(), 0.0);
    EXPECT_LT(largest, 1e-6);
}

TEST(MeshWallSphere, InACornerItTouchesTwoWallsAndOnARidgeOne) {
    const double deep = 0.995 * radius;
    const auto contact_at = [&](double degrees, const Vec3& x) {
        MeshHost<Sphere> host{{radius}, mesh_wall(sample::valley(degrees * pi / 180.0, 0.05, 0.1))};
        PairState pair{};
        pair.displacement = -x;
        pair.i.inverse_inertia = solid_sphere(1377.0, radius);
        const PairContact c = host(pair, elastic_law(), 1e-6);
        return std::pair(c, host.history.used);
    };
    const auto [corner, walls] = contact_at(90.0, {0.0, 0.0, std::sqrt(2.0) * deep});
    EXPECT_EQ(walls, 2U);
    const auto [ridge, one] = contact_at(-90.0, {0.0, 0.0, deep});
    EXPECT_EQ(one, 1U);
    EXPECT_NEAR(corner.force.z() / ridge.force.z(), std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace dem::test::mesh_walls
