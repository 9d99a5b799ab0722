// SPDX-License-Identifier: BSD-3-Clause
// Walls of triangles lead bodies along the paths of the surfaces that they stand for.
#include "runtime/contact/pairs/clump_wall.hpp"
#include "tests/physics/mesh_wall_host.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace dem::test::mesh_walls {
namespace {

TEST(MeshWallSphere, FiftyImpactsOnAPlateTurnedAnyWayTakeThePathsOfAPlane) {
    const ContactLaw law = rough_law();
    const MeshWall plate = mesh_wall(sample::plate({-0.05, -0.06}, {0.07, 0.05}, 13, 9));
    Random random(1, 0);
    for (int k = 0; k < 50; ++k) {
        const Quat turn = random.orientation();
        const Vec3 normal = turn * Vec3::UnitZ();
        TwoBodies a = thrown(random, -normal, 1.02 * radius);
        a.j.orientation = turn;
        TwoBodies b = a;
        MeshHost<Sphere> mesh{{radius}, plate};
        PlaneHost plane{Vec3::Zero(), normal};
        double largest = 0.0;
        for (int n = 0; n < 4000; ++n) {
            a.step(1e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
            b.step(1e-6, [&](const PairState& p, double dt) { return plane(p, law, dt); });
            largest = std::max(largest, difference(a, b));
        }
        EXPECT_LT(largest, 1e-9);
        EXPECT_GT(a.i.velocity.dot(normal), 0.0);
    }
}

TEST(MeshWallSphere, FiftyImpactsIntoEdgesAndCornersOfABoxTakeThePathsOfSixPlanes) {
    const ContactLaw law = rough_law();
    const Vec3 half(0.012, 0.015, 0.02);
    const MeshWall box = mesh_wall(sample::box_inside(-half, half));
    Random random(2, 0);
    for (int k = 0; k < 50; ++k) {
        TwoBodies a = thrown(random, random.direction(), 0.0);
        a.i.velocity *= 3.0;
        TwoBodies b = a;
        MeshHost<Sphere> mesh{{radius}, box};
        std::vector<PlaneHost> planes;
        for (int axis = 0; axis < 3; ++axis) {
            planes.push_back({-half[axis] * Vec3::Unit(axis), Vec3::Unit(axis)});
            planes.push_back({half[axis] * Vec3::Unit(axis), -Vec3::Unit(axis)});
        }
        double largest = 0.0;
        for (int n = 0; n < 20000; ++n) {
            a.step(1e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
            b.step(1e-6, [&](const PairState& p, double dt) {
                PairContact all;
                for (PlaneHost& plane : planes) all = sum(all, plane(p, law, dt));
                return all;
            });
            largest = std::max(largest, difference(a, b));
        }
        EXPECT_LT(largest, 1e-9) << k;
    }
}

/// How much a sphere that swings in a tube of facets differs in its distance from the axis from one
/// in a smooth tube, at most [m].
double largest_rise(int facets, double tube_radius) {
    const ContactLaw law = pair_law(rubber, rubber, 0.3);
    MeshHost<Sphere> mesh{{radius}, mesh_wall(sample::tube(tube_radius, -0.1, 0.1, facets))};
    TwoBodies a;
    a.i.inverse = solid_sphere(1377.0, radius);
    a.i.position = (tube_radius - radius) * Vec3(-0.6, -0.8, 0.0);
    a.acceleration = {0.0, -9.81, 0.0};
    TwoBodies b = a;
    PointHistory history{};
    double largest = 0.0;
    for (int n = 0; n < 60000; ++n) {
        a.step(2e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
        b.step(2e-6, [&](const PairState& p, double dt) {
            return collide(Sphere{radius}, CylinderWall{.radius = tube_radius},
                           Call{p, law, dt, memory_of(history)});
        });
        // Both have been let go where they touch one of the two.
        if (n < 10000) continue;
        largest = std::max(largest, std::abs(a.i.position.norm() - b.i.position.norm()));
    }
    return largest;
}

TEST(MeshWallSphere, ATubeOfFacetsLeadsAlongATubeWithinTheirSagitta) {
    const double tube_radius = 5.0 * radius;
    for (const int facets : {64, 128, 256, 512}) {
        const double sagitta = tube_radius * (1.0 - std::cos(pi / facets));
        const double rise = largest_rise(facets, tube_radius);
        RecordProperty("over_sagitta_" + std::to_string(facets), std::to_string(rise / sagitta));
        EXPECT_LT(rise, 1.05 * sagitta) << facets;
    }
}

TEST(MeshWallSphere, APlateOfSliversTurnedAnyWayIsAPlane) {
    // Strips of a thousandth of their length.
    sample::Surface slivers;
    const double length = 0.1;
    const double width = 1e-4;
    for (int k = -150; k < 150; ++k)
        slivers.add_quad({k * width, -0.5 * length, 0.0}, {(k + 1) * width, -0.5 * length, 0.0},
                         {(k + 1) * width, 0.5 * length, 0.0}, {k * width, 0.5 * length, 0.0});
    const ContactLaw law = rough_law();
    Random random(4, 0);
    for (int k = 0; k < 4; ++k) {
        const Quat turn = random.orientation();
        sample::Surface turned;
        for (const auto& t : slivers.soup().triangles)
            turned.add(turn * slivers.soup().points[t[0]], turn * slivers.soup().points[t[1]],
                       turn * slivers.soup().points[t[2]]);
        const Vec3 normal = turn * Vec3::UnitZ();
        TwoBodies a = thrown(random, -normal, radius);
        a.i.velocity = turn * Vec3(0.2, 0.1, 0.0);
        a.acceleration = -9.81 * normal;
        TwoBodies b = a;
        MeshHost<Sphere> mesh{{radius}, mesh_wall(turned)};
        PlaneHost plane{Vec3::Zero(), normal};
        double largest = 0.0;
        for (int n = 0; n < 5000; ++n) {
            a.step(4e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
            b.step(4e-6, [&](const PairState& p, double dt) { return plane(p, law, dt); });
            largest = std::max(largest, difference(a, b));
        }
        EXPECT_LT(largest, 1e-9);
    }
}

TEST(MeshWallClump, FiftyImpactsOnAPlateTakeThePathsOfAPlane) {
    const ContactLaw law = rough_law();
    const Clump candy = candy_clump(60);
    const MeshWall plate = mesh_wall(sample::plate({-0.05, -0.06}, {0.07, 0.05}, 13, 9));
    Random random(8, 0);
    for (int k = 0; k < 50; ++k) {
        TwoBodies a = thrown(random, -Vec3::UnitZ(), 7e-3);
        a.i.inverse = candy_inertia();
        a.i.orientation = random.orientation();
        a.i.angular_momentum *= 0.3;
        TwoBodies b = a;
        MeshHost<Clump> mesh{candy, plate};
        PatchHistory history{};
        NearCache cache{};
        ContactScratch scratch(4000);
        double travel = 0.0;
        double largest = 0.0;
        for (int n = 0; n < 30000; ++n) {
            a.step(2e-6, [&](const PairState& p, double dt) { return mesh(p, law, dt); });
            travel += 1.01 * 2e-6 * (b.i.velocity.norm() + 7e-3 * b.i.angular_velocity().norm());
            b.step(2e-6, [&](const PairState& p, double dt) {
                return collide(candy, PlaneWall{},
                               PatchCall{p, law, dt, {history, cache}, travel, {&scratch}});
            });
            largest = std::max(largest, difference(a, b));
        }
        EXPECT_LT(largest, 1e-9) << k;
    }
}

}  // namespace
}  // namespace dem::test::mesh_walls
