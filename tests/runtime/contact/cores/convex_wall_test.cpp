// SPDX-License-Identifier: BSD-3-Clause
#include "tests/runtime/contact/cores/core_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

TEST(ConvexContact, TheForceAtAWallIsTheGradientOfTheStoredEnergy) {
    for (const auto& [name, solid] : convex_solids()) {
        for (const bool is_tube : {false, true}) {
            Random random(4, 1);
            int off = 0;
            for (int k = 0; k < 20; ++k) {
                const Poses p = random_poses(random, k % 2 == 0 ? pi : 0.02);
                const auto evaluate = [&](const PairState& pair) {
                    Host host;
                    host.history.effective_radius = 0.25;
                    return is_tube
                               ? collide(solid.shape, CylinderWall{.radius = 3.0},
                                         host.call(pair, elastic, 1e-6))
                               : collide(solid.shape, PlaneWall{}, host.call(pair, elastic, 1e-6));
                };
                // The wall below the body, or the axis of the tube beside it.
                const auto pair_at = [&](double gap) {
                    const Vec3 displacement =
                        is_tube ? Vec3(gap - 3.0, 0.0, 0.0) : Vec3(0.0, 0.0, -gap);
                    return PairState{displacement, still(p.i), still(Quat::Identity())};
                };
                const double gap =
                    place_of(0.01, 2.0, [&](double x) { return evaluate(pair_at(x)).overlap; });
                const PairState pair = pair_at(gap);
                ASSERT_TRUE(evaluate(pair).touches()) << name;
                off += gradient_error(pair, evaluate) > 2e-5 ? 1 : 0;
            }
            EXPECT_EQ(off, 0) << name << (is_tube ? " in a tube" : " on a plane");
        }
    }
}

TEST(ConvexContact, AFlatEndAtATubeTouchesWithBothCornersWhateverTheAzimuth) {
    const ConvexSolid rod = make_cylinder(1.5, 3.0, 0.02);
    for (const double tilt : {0.0, 1e-12, 1e-4}) {
        for (int k = 0; k < 60; ++k) {
            const Vec3 outward(std::cos(0.1 * k), std::sin(0.1 * k), 0.0);
            const Quat q = Quat::FromTwoVectors(
                Vec3::UnitZ(), Vec3(outward + tilt * Vec3(-outward.y(), outward.x(), 0.5)));
            Host host;
            const double gap = std::sqrt(square(25.0 - 0.02) - square(1.48)) - 1.48;
            const PairState pair{-(gap + 1e-3) * outward, still(q), still(Quat::Identity())};
            const PairContact contact =
                collide(rod.shape, CylinderWall{.radius = 25.0}, host.call(pair, elastic, 1e-6));
            ASSERT_EQ(contact.points, 2U) << tilt << " " << k;
            const double off = tilt < 1e-6 ? 1e-6 : 0.1;  // one corner then carries more
            EXPECT_NEAR((contact.force.normalized() + outward).norm(), 0.0, off);
        }
    }
}

}  // namespace
}  // namespace dem::test
