// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/centroid.hpp"
#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/placed_core.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/clump_convex.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/pairs/convex_sr.hpp"
#include "runtime/contact/pairs/convex_wall.hpp"
#include "tests/runtime/contact/cores/convex_poses.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace dem::test {
namespace {

struct Host {
    ConvexHistory history{};
    MissCache miss{};
    ConvexScratch scratch{};

    ConvexMemory memory() { return {history, miss, scratch}; }
};

const ContactLaw elastic = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);

/// A contact of bodies at rest that has lasted: R* does not change.
template <class A, class B>
PairContact resting_contact(const A& a, const B& b, const PairState& pair) {
    Host host;
    host.history.effective_radius = 0.25;
    const double distance = pair.displacement.norm();
    host.history.search.direction = Vec3(pair.displacement / -distance);
    return collide(a, b, pair, elastic, 1e-6, host.memory());
}

/// Largest deviation of force and torques from the derivatives of the stored energy, relative to
/// the force.
template <class Evaluate>
double gradient_error(const PairState& pair, const Evaluate& evaluate) {
    const PairContact at = evaluate(pair);
    const double h = 1e-7;
    double error = 0.0;
    for (int k = 0; k < 9; ++k) {
        const Vec3 axis = Vec3::Unit(k % 3);
        const auto moved = [&](double s) {
            PairState p = pair;
            if (k < 3) {
                p.displacement -= s * axis;
            } else if (k < 6) {
                p.i.orientation = turned(axis, s) * pair.i.orientation;
            } else {
                p.j.orientation = turned(axis, s) * pair.j.orientation;
            }
            return evaluate(p).elastic_energy;
        };
        const double expected = -(moved(h) - moved(-h)) / (2.0 * h);
        const Vec3& found = k < 3 ? at.force : k < 6 ? at.torque_i : at.torque_j;
        error = std::max(error, std::abs(found.dot(axis) - expected) / at.force.norm());
    }
    return error;
}

// The heart of the matter: the force of features, ramps and all, has a potential.
TEST(ConvexContact, ForceAndTorquesAreTheGradientOfTheStoredEnergy) {
    const auto solids = convex_solids();
    for (const double tilt : {pi, 0.03}) {
        for (const auto& [name_a, a] : solids) {
            for (const auto& [name_b, b] : solids) {
                Random random(3, 1);
                int off = 0;
                for (int k = 0; k < 12; ++k) {
                    const Poses p = random_poses(random, tilt);
                    const auto pair_at = [&](double distance) {
                        return PairState{distance * p.direction + p.offset, still(p.i), still(p.j)};
                    };
                    const auto evaluate = [&](const PairState& pair) {
                        return resting_contact(a.shape, b.shape, pair);
                    };
                    const double distance =
                        place_of(0.01, 4.0, [&](double x) { return evaluate(pair_at(x)).overlap; });
                    const PairState pair = pair_at(distance);
                    if (!evaluate(pair).touches()) continue;
                    off += gradient_error(pair, evaluate) > 2e-5 ? 1 : 0;
                }
                // Kinks are met once in some hundred parallel pairs with a round one.
                EXPECT_LE(off, tilt < pi ? 1 : 0) << name_a << " - " << name_b << ' ' << tilt;
            }
        }
    }
}

// Both far points of the end carry, with weights that fade as it is tilted and towards the ends of
// the other body.
TEST(ConvexContact, AnEndThatRocksOnTheSideOfACylinderHasAPotential) {
    const ConvexSolid end = make_cylinder(1.0, 1.0, 0.05);
    const ConvexSolid side = make_cylinder(0.5, 3.0, 0.05);
    Random random(8, 1);
    int several = 0;
    for (int k = 0; k < 200; ++k) {
        const Quat lying = turned(Vec3::UnitY(), 0.5 * pi + random.uniform(-0.06, 0.06));
        const Vec3 beside(random.uniform(-1.5, 1.5), random.uniform(-1.1, 1.1), 0.0);
        const auto pair_at = [&](double height) {
            return PairState{beside + height * Vec3::UnitZ(), still(Quat::Identity()),
                             still(lying)};
        };
        const auto evaluate = [&](const PairState& pair) {
            return resting_contact(end.shape, side.shape, pair);
        };
        const PairState pair =
            pair_at(place_of(0.01, 4.0, [&](double x) { return evaluate(pair_at(x)).overlap; }));
        const PairContact contact = evaluate(pair);
        if (!contact.touches()) continue;
        several += contact.points > 1 ? 1 : 0;
        EXPECT_LT(gradient_error(pair, evaluate), 2e-5) << k;
    }
    EXPECT_GT(several, 50);
}

std::vector<ConvexSolid> grains() {
    return {make_cuboid({1.0, 1.4, 0.6}, 0.02), make_cuboid({1.2, 1.0, 0.05}, 0.01),
            rounded_hull(tetrahedron_corners(1.5), 0.03), random_polyhedron(20, 1, 0.02),
            random_polyhedron(6, 2, 0.01)};
}

/// Two of the grains in a random pose, overlapping by up to half of their roundings.
struct TouchingGrains {
    const ConvexShape& a;
    const ConvexShape& b;
    PairState pair;
};
TouchingGrains touching_grains(const std::vector<ConvexSolid>& solids, int k, Random& random) {
    const ConvexShape& a = solids[static_cast<std::size_t>(k) % solids.size()].shape;
    const ConvexShape& b = solids[static_cast<std::size_t>(k) / 5 % solids.size()].shape;
    const double tilt = k % 3 == 0 ? std::pow(10.0, random.uniform(-4.0, 0.0)) : pi;
    const Poses p = random_poses(random, tilt);
    const double wanted = std::pow(10.0, random.uniform(-4.0, -0.3)) * (a.rounding + b.rounding);
    const auto pair_at = [&](double x) {
        return PairState{x * p.direction + p.offset, still(p.i), still(p.j)};
    };
    const double x =
        place_of(wanted, 4.0, [&](double y) { return resting_contact(a, b, pair_at(y)).overlap; });
    return {a, b, pair_at(x)};
}

/// What a contact remembers of its first step.
Host after_first_step(const ConvexShape& a, const ConvexShape& b, const PairState& pair) {
    Host host;
    host.history.effective_radius = 0.25;
    host.history.search.direction = Vec3(pair.displacement.normalized() * -1.0);
    collide(a, b, pair, elastic, 1e-6, host.memory());
    return host;
}

// Most contacts of grains are a vertex on a face or an edge across another: found to be alone
// they give, to the bit, what all features give.
TEST(ConvexContact, ALoneFeatureIsAllThereIs) {
    const std::vector<ConvexSolid> solids = grains();
    Random random(12, 4);
    int touching = 0;
    int lone = 0;
    ConvexScratch scratch;
    for (int k = 0; k < 4000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
        const PlacedCore j(b, pair.j.orientation, pair.displacement);
        const CoreDistance found = core_distance(i, j, canonical_start(pair.displacement), 0.0);
        if (found.overlaps || found.distance >= i.rounding + j.rounding) continue;
        const ConvexTouch touch = touch_of(i, j, found);
        FeatureSum alone(pair, touch.point.overlap);
        ++touching;
        LoneFeature found_lone;
        Leash leash;
        if (!add_lone_feature(i, j, touch.near, alone, found_lone, leash)) continue;
        ++lone;
        FeatureSum all(pair, touch.point.overlap);
        add_polyhedra(i, j, touch.near, scratch, all);
        ASSERT_EQ(alone.count(), all.count()) << k;
        ASSERT_EQ(alone.power(), all.power()) << k;
        ASSERT_EQ(alone.direction().torque_i, all.direction().torque_i) << k;
        ASSERT_EQ(alone.of_weights().torque_j, all.of_weights().torque_j) << k;
    }
    EXPECT_GT(touching, 3000);
    EXPECT_GT(lone, touching / 4);
    RecordProperty("lone", lone);
}

// The proof that nothing else touches covers the motion for which it is used.
TEST(ConvexContact, ALoneFeatureStaysAloneAsLongAsItsRoomLasts) {
    const std::vector<ConvexSolid> solids = grains();
    Random random(12, 5);
    int used = 0;
    int outside = 0;
    for (int k = 0; k < 3000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const Host before = after_first_step(a, b, pair);
        const LoneFeature& lone = before.history.lone;
        const Leash& leash = before.history.leash;
        for (int n = 0; n < 4 && lone.kind != LoneFeature::Kind::none; ++n) {
            const double angle = leash.room * random.uniform();
            PairState moved = pair;
            moved.displacement += random.uniform(0.0, 0.7) * leash.room * random.direction();
            moved.i.orientation = turned(random.direction(), 0.3 * angle) * pair.i.orientation;
            moved.j.orientation = turned(random.direction(), 0.3 * angle) * pair.j.orientation;
            const PlacedCore i(a, moved.i.orientation, Vec3::Zero());
            const PlacedCore j(b, moved.j.orientation, moved.displacement);
            Host host;
            host.history = before.history;
            if (!holds(leash, moved, j.size) ||
                !(lone_overlap(i, j, lone, host.history.normal) > 0.0)) {
                ++outside;
                continue;
            }
            ++used;
            const PairContact quick = collide(a, b, moved, elastic, 1e-6, host.memory());
            ASSERT_NE(host.history.lone.kind, LoneFeature::Kind::none);
            const PairContact whole = resting_contact(a, b, moved);
            // Rounding of the distance, relative to the overlap.
            const double bound = 1e-13 / whole.overlap + 1e-9;
            ASSERT_NEAR(quick.overlap, whole.overlap, 1e-13 + 1e-12 * whole.overlap) << k;
            ASSERT_LT((quick.force - whole.force).norm(), bound * whole.force.norm()) << k;
            ASSERT_LT((quick.torque_i - whole.torque_i).norm(), bound * whole.force.norm()) << k;
            ASSERT_LT((quick.torque_j - whole.torque_j).norm(), bound * whole.force.norm()) << k;
        }
    }
    EXPECT_GT(used, 2000);
    EXPECT_GT(outside, 50);
    RecordProperty("used", used);
}

// Nearly along the axis, what rounding leaves of a direction is as long as what lies across.
TEST(ConvexContact, TheFarthestPointOfAnEndLiesOnItHoweverSmallTheTilt) {
    Random random(12, 7);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 axis = random.direction();
        const PlacedCap cap{random.direction(), axis, 2.0, 2.0, 0.01, axis.unitOrthogonal()};
        const double tilt = std::pow(10.0, random.uniform(-13.0, 0.0));
        const Vec3 direction = turned(random.direction(), tilt) * axis;
        const Vec3 from_center = cap.support(direction, 0).position - cap.center;
        ASSERT_NEAR(from_center.dot(axis), 0.0, 1e-15) << tilt;
        ASSERT_LE(from_center.norm(), cap.radius + 1e-15) << tilt;
    }
}

// What is left out of the ends of cylinders and cones while the leash lasts adds nothing: not a bit
// changes.
TEST(ConvexContact, WhatIsLeftOutOfEndsTouchesNothing) {
    const std::vector<ConvexSolid> solids = {
        make_cylinder(0.6, 1.2, 0.02), make_cylinder(0.5, 0.1, 0.01), make_cylinder(0.3, 2.0, 0.02),
        make_cone(0.7, 1.2, 0.02), make_cuboid({1.0, 1.4, 0.6}, 0.02)};
    Random random(12, 6);
    int used = 0;
    for (int k = 0; k < 3000; ++k) {
        const auto& [a, b, pair] = touching_grains(solids, k, random);
        const Host before = after_first_step(a, b, pair);
        const double room = before.history.leash.room;
        for (int n = 0; n < 4 && room > 0.0; ++n) {
            PairState moved = pair;
            moved.displacement += random.uniform(0.0, 0.7) * room * random.direction();
            moved.i.orientation =
                turned(random.direction(), random.uniform(0.0, 0.3) * room) * pair.i.orientation;
            Host with;
            Host without;
            with.history = without.history = before.history;
            without.history.leash.room = 0.0;
            if (!holds(before.history.leash, moved, b.bounding_radius)) continue;
            const PairContact quick = collide(a, b, moved, elastic, 1e-6, with.memory());
            const PairContact whole = collide(a, b, moved, elastic, 1e-6, without.memory());
            ++used;
            ASSERT_EQ(quick.overlap, whole.overlap) << k;
            ASSERT_EQ(quick.force, whole.force) << k;
            ASSERT_EQ(quick.torque_i, whole.torque_i) << k;
            ASSERT_EQ(quick.torque_j, whole.torque_j) << k;
        }
    }
    EXPECT_GT(used, 5000);
    RecordProperty("used", used);
}

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
                    return is_tube ? collide(solid.shape, CylinderWall{.radius = 3.0}, pair,
                                             elastic, 1e-6, host.memory())
                                   : collide(solid.shape, PlaneWall{}, pair, elastic, 1e-6,
                                             host.memory());
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
            const PairContact contact = collide(rod.shape, CylinderWall{.radius = 25.0}, pair,
                                                elastic, 1e-6, host.memory());
            ASSERT_EQ(contact.points, 2U) << tilt << " " << k;
            const double off = tilt < 1e-6 ? 1e-6 : 0.1;  // one corner then carries more
            EXPECT_NEAR((contact.force.normalized() + outward).norm(), 0.0, off);
        }
    }
}

TEST(ConvexContact, ASphereOfAnyKindTouchesAlike) {
    const ConvexSolid ball = make_convex_sphere(0.5);
    const Sphere sphere{0.4};
    Random random(11, 1);
    for (const auto& [name, solid] : convex_solids()) {
        for (int k = 0; k < 50; ++k) {
            const Vec3 n = random.direction();
            const Quat q = random.orientation();
            const double x = random.uniform(0.3, 1.8);
            const PairState pair{x * n, still(q), still(random.orientation())};
            const PairContact as_sphere = resting_contact(solid.shape, sphere, pair);
            const SurfaceDistance d = surface_distance(solid.shape, q.conjugate() * (x * n));
            ASSERT_EQ(as_sphere.touches(), d.distance < 0.4) << name;
            if (!as_sphere.touches()) continue;
            ASSERT_NEAR(as_sphere.overlap, 0.4 - d.distance, 1e-12) << name;
            const PairState back{-x * n, pair.j, pair.i};
            const PairContact other = resting_contact(sphere, solid.shape, back);
            ASSERT_NEAR((other.force + as_sphere.force).norm(), 0.0, 1e-9 * other.force.norm());
            const Clump one = make_clump({{0.0, 0.0, 0.0, 0.4, 1.0}});
            PatchHistory history;
            NodeCache cache;
            ContactScratch scratch(100);
            history.effective_radius = 0.25;
            const PairContact as_clump =
                collide(solid.shape, one, pair, elastic, 1e-6, {history, cache, scratch, 0.0});
            ASSERT_NEAR((as_clump.force - as_sphere.force).norm(), 0.0, 1e-9 * other.force.norm());
        }
    }
    const PairContact two =
        resting_contact(ball.shape, ball.shape, {{0.0, 0.0, 0.9}, still({}), still({})});
    EXPECT_NEAR(two.overlap, 0.1, 1e-12);
}

// Cores that overlap: the contact goes on as if they did not.
TEST(ConvexContact, OverlapRisesThroughTheOverlapOfTheCores) {
    for (const auto& [name, solid] : convex_solids()) {
        if (solid.shape.is_strictly_convex()) continue;
        Random random(12, 1);
        for (int k = 0; k < 10; ++k) {
            const Poses p = random_poses(random, k < 5 ? pi : 0.0);
            double last = 0.0;
            double last_x = 0.0;
            for (double x = 2.5; x > 0.1; x -= 1e-3) {
                const PairContact c = resting_contact(solid.shape, solid.shape,
                                                      {x * p.direction, still(p.i), still(p.j)});
                if (last > 0.0) {
                    ASSERT_GT(c.overlap, 0.95 * last) << name << ' ' << x;
                    ASSERT_LT(c.overlap, last + 4.0 * (last_x - x)) << name << ' ' << x;
                    ASSERT_TRUE(c.force.allFinite() && c.torque_i.allFinite());
                }
                last = c.overlap;
                last_x = x;
                if (last > 0.15) break;
            }
            EXPECT_GT(last, 0.0);
        }
    }
}

// What a pair remembers of a miss must not change a bit of the contact that follows.
TEST(ConvexContact, TheMissCacheNeverChangesABit) {
    Random random(13, 1);
    const auto solids = convex_solids();
    for (int k = 0; k < 400; ++k) {
        const ConvexShape& a = solids[static_cast<std::size_t>(k) % solids.size()].second.shape;
        const ConvexShape& b =
            solids[static_cast<std::size_t>(k) / 10 % solids.size()].second.shape;
        const Poses p = random_poses(random, k % 2 == 0 ? pi : 1e-3);
        Host fresh;
        Host used;
        bool touched = false;
        for (double x = 2.6; x > 1.0 && !touched; x -= 0.01) {
            const PairState pair{x * p.direction + p.offset, still(p.i), still(p.j)};
            fresh.miss = {};
            const PairContact c = collide(a, b, pair, elastic, 1e-6, fresh.memory());
            const PairContact d = collide(a, b, pair, elastic, 1e-6, used.memory());
            ASSERT_EQ(c.touches(), d.touches());
            ASSERT_EQ(c.force, d.force);
            ASSERT_EQ(c.torque_i, d.torque_i);
            touched = c.touches();
            if (!touched && used.miss.gap > 0.0) {
                const Vec3 toward = used.miss.gap * (1.0 - 1e-9) * random.direction();
                PairState nearer = pair;
                nearer.displacement += toward;
                Host other;
                ASSERT_FALSE(collide(a, b, nearer, elastic, 1e-6, other.memory()).touches());
            }
        }
    }
}

// Against sums over a fine grid of points in both polygons.
TEST(ConvexContact, CentroidOfACommonPatchIsThatOfItsPoints) {
    Random random(5, 2);
    const auto polygon = [&](std::size_t count) {
        std::vector<Vec2> points;
        for (std::size_t k = 0; k < count; ++k)
            points.emplace_back(random.uniform(), random.uniform());
        return points;
    };
    const auto holds = [](const std::vector<Vec2>& points, const Vec2& x) {
        // x is in the hull unless some line through it leaves all points on one side.
        for (int k = 0; k < 720; ++k) {
            const Vec2 n(std::cos(k * pi / 360.0), std::sin(k * pi / 360.0));
            if (std::all_of(points.begin(), points.end(),
                            [&](const Vec2& p) { return n.dot(p - x) < 0.0; }))
                return false;
        }
        return true;
    };
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<Vec2> a = polygon(6);
        std::vector<Vec2> b = polygon(5);
        Vec2 sum = Vec2::Zero();
        int inside = 0;
        for (int n = 0; n < 1600; ++n) {
            const Vec2 x((n % 40 + 0.5) / 40.0, (n / 40 + 0.5) / 40.0);
            if (!holds(a, x) || !holds(b, x)) continue;
            sum += x;
            ++inside;
        }
        Vec2 centroid;
        ASSERT_EQ(common_centroid(a, b, centroid), inside > 0);
        if (inside == 0) continue;
        EXPECT_LT((centroid - sum / inside).norm(), 0.02) << trial;
    }
    // A segment across a square, and two segments along each other.
    std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Vec2> line{{-1, 0.25}, {0.5, 0.25}};
    std::vector<Vec2> along{{0, 0.25}, {3, 0.25}};
    Vec2 centroid;
    ASSERT_TRUE(common_centroid(square, line, centroid));
    EXPECT_LT((centroid - Vec2(0.25, 0.25)).norm(), 1e-12);
    ASSERT_TRUE(common_centroid(line, along, centroid));
    EXPECT_LT((centroid - Vec2(0.25, 0.25)).norm(), 1e-12);
}

// A cube on a shifted cube: one force through the middle of the rectangle they share, and the same
// overlap as by features.
TEST(ConvexContact, CentroidRuleActsInTheMiddleOfThePatch) {
    const ConvexSolid cube = make_cuboid(Vec3::Ones(), 0.01);
    const PairState pair{{0.3, 0.2, -0.999}, still(Quat::Identity()), still(Quat::Identity())};
    ContactLaw law = elastic;
    law.method = ContactLaw::Method::centroid;
    Host host;
    host.history.effective_radius = 0.25;
    host.history.search.direction = Vec3(0.0, 0.0, 1.0);
    const PairContact contact = collide(cube.shape, cube.shape, pair, law, 1e-6, host.memory());
    ASSERT_EQ(contact.points, 1U);
    EXPECT_NEAR(contact.overlap, 1e-3, 1e-9);
    EXPECT_LT((contact.force.normalized() - Vec3::UnitZ()).norm(), 1e-9);
    const Vec3 lever(0.15, 0.1, -0.4995);
    EXPECT_LT((contact.torque_i - lever.cross(contact.force)).norm(), 1e-6 * contact.force.norm());
    EXPECT_FALSE(contact.cores_met);
}

// Counted when it happens, not again in the same contact.
TEST(ConvexContact, CoresThatOverlapAreCountedOnce) {
    const ConvexSolid cube = make_cuboid(Vec3::Ones(), 0.01);
    const PairState pair{{0.1, 0.0, -0.97}, still(Quat::Identity()), still(Quat::Identity())};
    Host host;
    const auto contact = [&] {
        return collide(cube.shape, cube.shape, pair, elastic, 1e-6, host.memory());
    };
    EXPECT_TRUE(contact().cores_met);
    EXPECT_FALSE(contact().cores_met);
}

}  // namespace
}  // namespace dem::test
