// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"
#include "tests/physics/contact_of.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// Bodies with flat ends on slopes that friction holds: they come to rest and stay.
namespace dem::test {

using namespace runtime;
using namespace shapegen;

namespace {

constexpr double density = 1200.0;
constexpr double size = 5e-3;
constexpr double dt = 5e-6;

struct Standing {
    std::string name;
    ConvexSolid solid;
    double height;  ///< of the center above the ground [m]
};

/// A regular prism upon its end.
ConvexSolid prism(int corners, double radius, double height) {
    std::vector<Vec3> points;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * pi * k / corners;
        for (const double z : {-0.5 * height, 0.5 * height})
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return rounded_hull(points, 0.01 * radius);
}

std::vector<Standing> bodies() {
    const double r = 0.02 * size;
    return {{"cylinder", make_cylinder(0.5 * size, size, r), 0.5 * size},
            {"coin", make_cylinder(0.5 * size, 0.3 * size, r), 0.15 * size},
            {"cone", make_cone(0.5 * size, size, r), size / 4.0},
            {"cuboid", make_cuboid({size, 1.3 * size, size}, r), 0.5 * size},
            {"hexagonal prism", prism(6, 0.5 * size, size), 0.5 * size}};
}

InverseInertia inertia_of(const ConvexSolid& solid) {
    const MassProperties& m = solid.mass_properties;
    const Vec3 moments = density * m.principal_moments_per_density;
    InverseInertia inverse = inverse_inertia(density * m.volume, moments);
    inverse.surface = solid.mean_squared_surface_distance / moments.mean();
    return inverse;
}

struct End {
    double creep;    ///< [m/s]
    double kinetic;  ///< over what a fall by the size gives
    double before;   ///< the same a while earlier
};

/// Stands upright at z = 0 on a body that does not move.
End stand(const Standing& body, const Contact& contact, double slope,
          const Vec3& center_below = Vec3::Zero()) {
    TwoBodies b;
    b.j.position = center_below;
    b.i.inverse = inertia_of(body.solid);
    b.i.position.z() = body.height;
    b.acceleration = 9.81 * Vec3(std::sin(slope), 0.0, -std::cos(slope));
    const double scale = 9.81 * size / b.i.inverse.mass;
    End end{};
    const auto run = [&](double time) {
        for (int k = 0; k < std::lround(time / dt); ++k) b.step(dt, contact);
    };
    run(0.25);
    end.before = b.kinetic_energy() / scale;
    run(0.2);
    const Vec3 from = b.i.position;
    run(0.05);
    end.creep = (b.i.position - from).norm() / 0.05;
    end.kinetic = b.kinetic_energy() / scale;
    return end;
}

void expect_rest(const End& end, const std::string& what) {
    EXPECT_LT(end.creep, 1e-6) << what;
    EXPECT_LT(end.kinetic, 1e-8) << what;
    // To where rounding keeps it.
    EXPECT_LT(end.kinetic, std::max(0.1 * end.before, 1e-20)) << what;
}

ContactLaw law_of(double restitution, double friction) {
    const Elasticity stuff{5e7, 0.3};
    ContactLaw options;
    options.friction = friction;
    return pair_law(stuff, stuff, restitution, options);
}

TEST(Standing, BodiesComeToRestOnSlopesThatFrictionHolds) {
    struct Slope {
        double degrees, friction;
    };
    for (const Standing& body : bodies())
        for (const Slope& slope : {Slope{25.0, 0.6}, Slope{38.0, 5.0}})
            for (const double restitution : {0.3, 0.9}) {
                const double angle = slope.degrees * pi / 180.0;
                const ContactLaw law = law_of(restitution, slope.friction);
                const Contact contact = by_cores(body.solid.shape, PlaneWall{}, law);
                expect_rest(stand(body, contact, angle),
                            body.name + ", restitution " + std::to_string(restitution));
            }
}

TEST(Standing, BodiesComeToRestOnOthers) {
    const ConvexSolid table = make_cuboid({4.0 * size, 4.0 * size, 2.0 * size}, 0.02 * size);
    const Vec3 down(0.0, 0.0, -size);
    for (const Standing& body : bodies()) {
        const Contact contact = by_cores(body.solid.shape, table.shape, law_of(0.5, 1.5));
        expect_rest(stand(body, contact, 38.0 * pi / 180.0, down), body.name + " on a table");
    }
}

}  // namespace
}  // namespace dem::test
