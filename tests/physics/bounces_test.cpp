// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/thread_team.hpp"
#include "tests/physics/bounces/bounce_table.hpp"

#include <gtest/gtest.h>

#ifndef BOUNCES
#define BOUNCES 20
#define SHARP_BOUNCES 30
#endif

// Elastic bounces of every pair of kinds at a hundredth of the critical time step
// (docs/validation/bounces.md).
namespace dem::test {

using namespace runtime;

namespace {

bool is_angular(Kind k) {
    return k == Kind::polyhedron || k == Kind::cylinder || k == Kind::cone;
}

/// Force of a potential that is continuous but has edges: where one face or end takes over from
/// another the direction turns at once, or within a narrow band where a side is nearly straight,
/// and a step that passes the place is wrong by up to the force times the way of one step. A
/// tenfold smaller step makes it ten times less.
bool has_creases(Kind i, Kind j) {
    return is_angular(i) && (j == Kind::rod || is_angular(j)) &&
           !(i == Kind::cylinder && j == Kind::rod);
}

struct Bounds {
    double jump, mean;
};
Bounds bounds_of(Kind i, Kind j) {
    // Faces that rock on a plane, edges that slip off that of a rod, sides about as curved as a
    // tube: up to 1.5e-3 in thousands.
    if (i == Kind::sharp && (j == Kind::plane || j == Kind::rod)) return {2e-3, 1e-4};
    if (i == Kind::smooth && j == Kind::tube) return {2e-3, 1e-5};
    // Nodes share the steps across the creases of exact fields; those of interpolated ones jump by
    // up to 3.8e-3 in 3000 bounces.
    if (i == Kind::nodes && (is_angular(j) || j == Kind::rod || j == Kind::nodes))
        return {1e-3, 1e-4};
    return has_creases(i, j) ? Bounds{1e-2, 1e-4} : Bounds{1e-3, 1e-5};
}

TEST(Bounces, NoPairOfKindsGainsOrLosesEnergyAtOnce) {
    ThreadTeam team(0);
    const ThreadTeam::InForce in_force(&team);
    BounceSettings settings;
    settings.divisor = 100.0;
    for_every_pair([&](Kind i, Kind j) {
        settings.i = i;
        settings.j = j;
        const bool is_sharp = has_edges(i) && (has_edges(j) || is_wall(j));
        const BounceSummary s = bounces(settings, 0, is_sharp ? SHARP_BOUNCES : BOUNCES);
        const Bounds bounds = bounds_of(i, j);
        EXPECT_LT(s.worst_jump, bounds.jump)
            << name(i) << " and " << name(j) << ", seed " << s.worst[0].seed;
        EXPECT_LT(s.mean_change, bounds.mean) << name(i) << " and " << name(j);
    });
}

// Seeds that a search for the normal or a step across a crease once got wrong.
TEST(Bounces, PlacesWhereContactsBeganOrEndedAtOnceAreKnown) {
    struct Case {
        Kind i, j;
        std::uint64_t seed;
    };
    constexpr std::array cases = {
        Case{Kind::sharp, Kind::sharp, 13022},      // a tip slips off the rim of a face
        Case{Kind::sharp, Kind::sharp, 19797},      //
        Case{Kind::sharp, Kind::tube, 148},         // two places at a tube become one
        Case{Kind::sharp, Kind::tube, 6475},        // a face seen edge on, between two places
        Case{Kind::sharp, Kind::rod, 84},           // an edge slips off the edge of a rod
        Case{Kind::sharp, Kind::rod, 1428},         // beside the rod, beyond the plane of its end
        Case{Kind::cylinder, Kind::tube, 833},      // two places of a rim at a tube
        Case{Kind::cylinder, Kind::rod, 2571},      // an end rocks on a side
        Case{Kind::cylinder, Kind::cylinder, 757},  //
        Case{Kind::smooth, Kind::plane, 1023},      // a straight side rocks on a plane
        Case{Kind::nodes, Kind::cylinder, 298},     // nodes pass from one face to another
        Case{Kind::nodes, Kind::cylinder, 108},     //
        Case{Kind::nodes, Kind::cone, 19},          //
        Case{Kind::nodes, Kind::polyhedron, 288},   //
        Case{Kind::nodes, Kind::rod, 127}};
    for (const Case& c : cases) {
        BounceSettings settings;
        settings.i = c.i;
        settings.j = c.j;
        settings.divisor = 100.0;
        const Bounce b = bounce(settings, c.seed);
        EXPECT_TRUE(b.touched);
        EXPECT_LT(b.jump, c.j == Kind::rod ? 2e-3 : 1e-3)  // a crease at the rod's edge
            << name(c.i) << " and " << name(c.j) << ", seed " << c.seed;
    }
}

}  // namespace
}  // namespace dem::test
