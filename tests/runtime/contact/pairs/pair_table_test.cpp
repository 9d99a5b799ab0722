// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/pair_table.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

template <class... Row>
std::set<std::string> names(PairTable<Row...>) {
    return {Row::name()...};
}

// Checkpoints know contacts by these words: a row may come, but none may be called otherwise.
TEST(PairTable, RowsHaveNamesThatCheckpointsCanHangOn) {
    std::set<std::string> all = names(ParticlePairs{});
    all.merge(names(WallPairs{}));
    EXPECT_EQ(all.size(), ParticlePairs::size + WallPairs::size);
    for (const char* known : {"sphere-sphere",     "sphere-sr",      "sr-sr",
                              "sphere-sr.nodes",   "sr-sr.nodes",    "clump-clump",
                              "sphere-clump",      "clump-sr",       "convex-convex",
                              "sphere-convex",     "sr-convex",      "sr-convex.nodes",
                              "clump-convex",      "sphere-plane",   "sphere-cylinder",
                              "sr-plane",          "sr-cylinder",    "sr-plane.nodes",
                              "sr-cylinder.nodes", "clump-plane",    "clump-cylinder",
                              "convex-plane",      "convex-cylinder"})
        EXPECT_TRUE(all.contains(known)) << known;
}

TEST(PairTable, AKernelGivenThePairTheOtherWayRoundSaysTheOpposite) {
    ContactLaw law;
    law.youngs_modulus = 1e7;
    law.shear_modulus = 1e6;
    law.friction = 0.5;
    PairState pair{{1e-3, 2e-3, 5.5e-3}, {}, {}};
    pair.i.angular_velocity = {3.0, -2.0, 1.0};
    pair.j.velocity = {0.1, 0.2, -0.3};
    pair.i.inverse_inertia = {1e3, Vec3::Constant(1e8)};
    pair.j.inverse_inertia = {2e3, Vec3::Constant(3e8)};
    const Sphere a{3e-3};
    const Sphere b{4e-3};
    PointHistory h1, h2;
    NoCache none;
    const PairContact c = collide(a, b, Call{pair, law, 1e-6, Memory{h1, none}});
    const PairState back = reversed(pair);
    const PairContact d =
        reversed(collide(b, a, Call{back, law, 1e-6, Memory{h2, none}}), pair.displacement);
    ASSERT_TRUE(c.touches());
    const double tolerance = 1e-12 * c.force.norm();
    EXPECT_LE((c.force - d.force).norm(), tolerance);
    EXPECT_LE((c.torque_i - d.torque_i).norm(), 1e-2 * tolerance);
    EXPECT_LE((c.torque_j - d.torque_j).norm(), 1e-2 * tolerance);
    EXPECT_EQ(c.overlap, d.overlap);
}

// A checkpoint of spheres must not be taken for one of clumps: each of the two shapes of a pair
// says which row it belongs to, in either order.
TEST(PairTable, APairBelongsToOneRowInEitherOrder) {
    ParticleTemplate sphere;
    sphere.shape = Sphere{1e-3};
    sphere.is_convex = true;
    ParticleTemplate clump;
    clump.shape = Clump{};
    const auto name = [](const ParticleTemplate& a, const ParticleTemplate& b) {
        return ParticlePairs::at_row_of(a, b, ContactLaw{},
                                        []<class Row>() { return Row::name(); });
    };
    EXPECT_EQ(name(sphere, clump), "sphere-clump");
    EXPECT_EQ(name(clump, sphere), "sphere-clump");
    EXPECT_EQ(name(sphere, sphere), "sphere-sphere");
}

}  // namespace
}  // namespace dem::runtime
