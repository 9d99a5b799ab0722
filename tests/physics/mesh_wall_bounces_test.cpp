// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/mesh_wall_host.hpp"

#include <gtest/gtest.h>

namespace dem::test::mesh_walls {
namespace {

/// A body of which each bounce off a tetrahedron must keep the energy.
template <class Shape>
struct Bouncer {
    Shape shape;
    InverseInertia inverse;
    double reach;  ///< [m]
};

template <class Shape>
std::pair<double, double> bounce_errors(const Bouncer<Shape>& body, int bounces, double dt) {
    const ContactLaw law = elastic_law();
    const MeshWall wall = mesh_wall(sample::tetrahedron_outside(0.02));
    Random random(6, 0);
    double total = 0.0;
    double worst = 0.0;
    for (int k = 0; k < bounces;) {
        TwoBodies a;
        a.i.inverse = body.inverse;
        a.i.orientation = random.orientation();
        const Vec3 from = random.direction();
        a.i.position = (0.0125 + body.reach) * from;
        a.i.velocity = 0.3 * (-from + 0.3 * random.direction());
        a.i.angular_momentum = 10.0 / a.i.inverse.moments.x() * random.direction();
        MeshHost<Shape> host{body.shape, wall};
        const double start = a.kinetic_energy();
        bool touched = false;
        for (int n = 0; n < 200000; ++n) {
            a.step(dt, [&](const PairState& p, double h) { return host(p, law, h); });
            touched = touched || a.contact.touches();
            if (!a.contact.touches() && a.i.position.norm() > 0.013 + body.reach) break;
        }
        if (!touched) continue;
        const double error = std::abs(a.kinetic_energy() / start - 1.0);
        total += error;
        worst = std::max(worst, error);
        ++k;
    }
    return {total / bounces, worst};
}

TEST(MeshWallSphere, ElasticBouncesOffFacesEdgesAndCornersOfATetrahedronKeepTheEnergy) {
    const auto [mean, worst] =
        bounce_errors(Bouncer<Sphere>{{radius}, solid_sphere(1377.0, radius), radius}, 100, 1e-6);
    RecordProperty("mean", std::to_string(mean));
    EXPECT_LT(mean, 1e-6);
    EXPECT_LT(worst, 1e-3);
}

TEST(MeshWallClump, ElasticBouncesOffATetrahedronKeepTheEnergy) {
    const auto [mean, worst] =
        bounce_errors(Bouncer<Clump>{candy_clump(30), candy_inertia(), 6.6e-3}, 60, 1e-6);
    RecordProperty("mean", std::to_string(mean));
    EXPECT_LT(mean, 1e-6);
    EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace dem::test::mesh_walls
