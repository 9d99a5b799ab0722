// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "runtime/contact/smooth/sr_curvature.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

const SrShape& shape(int which) {
    static const std::array<SrShape, 4> all = {candy(), sharp_tablet(), peanut(), red_blood_cell()};
    return all[static_cast<std::size_t>(which)];
}

/// A sphere cooked as a surface of revolution.
const SrShape& round_shape() {
    static const SrShape sphere = make_sr_shape(spheroid_outline(5e-3, 5e-3), true, 4000);
    return sphere;
}

ContactLaw law_with(double restitution, double friction) {
    ContactLaw options;
    options.friction = friction;
    return pair_law({5e7, 0.3}, {5e7, 0.3}, restitution, options);
}

/// A pair seen for the first time: nothing remembered.
struct Fresh {
    PatchHistory history{};
    NearCache cache{};
    ContactScratch scratch = ContactScratch(6000);
    PatchCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {history, cache}, 0.0, {&scratch}};
    }
};

template <class A, class B>
PairContact first_touch(const A& a, const B& b, const PairState& pair, const ContactLaw& law) {
    Fresh fresh;
    return collide(a, b, fresh.call(pair, law, 1e-6));
}

/// Two bodies that meet with spin.
TwoBodies meeting(const SrShape& a, const SrShape& b, Random& random) {
    TwoBodies bodies;
    bodies.i.inverse = solid_sphere(1200.0, 0.5 * a.equivalent_diameter);
    bodies.j.inverse = solid_sphere(1200.0, 0.5 * b.equivalent_diameter);
    // Not a sphere's: the axes must matter.
    bodies.i.inverse.moments.z() *= 0.7;
    bodies.j.inverse.moments.z() *= 1.3;
    bodies.i.orientation = random.orientation();
    bodies.j.orientation = random.orientation();
    const Vec3 towards = random.direction();
    bodies.j.position = 0.95 * (a.bounding_radius + b.bounding_radius) * towards;
    bodies.i.velocity = 0.5 * towards;
    bodies.j.velocity = -0.5 * towards;
    bodies.i.angular_momentum = 50.0 / bodies.i.inverse.moments.x() * random.direction();
    bodies.j.angular_momentum = 50.0 / bodies.j.inverse.moments.x() * random.direction();
    return bodies;
}

bool same_bits(const Body& a, const Body& b) {
    return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs() &&
           a.velocity == b.velocity && a.angular_momentum == b.angular_momentum;
}

TEST(NodeContact, WhatAPairRemembersNeverChangesABitOfItsMotion) {
    Random random(21, 0);
    const ContactLaw law = law_with(0.6, 0.3);
    int touching_steps = 0;
    int kernel_calls = 0;
    for (int run = 0; run < 16; ++run) {
        const SrShape& a = shape(run % 4);
        const SrShape& b = shape(run / 4);
        TwoBodies with = meeting(a, b, random);
        TwoBodies without = with;
        Fresh kept;
        Fresh forgotten;
        double travel = 0.0;
        const double dt = 5e-6;
        for (int step = 0; step < 1500; ++step) {
            travel += 1.01 * dt *
                      (with.i.velocity.norm() + with.j.velocity.norm() +
                       with.i.angular_velocity().norm() * a.bounding_radius +
                       with.j.angular_velocity().norm() * b.bounding_radius);
            with.step(dt, [&](const PairState& pair, double h) -> PairContact {
                if (travel < kept.cache.clear_until) return {};
                ++kernel_calls;
                return collide(
                    a, b,
                    PatchCall{pair, law, h, {kept.history, kept.cache}, travel, {&kept.scratch}});
            });
            without.step(dt, [&](const PairState& pair, double h) {
                forgotten.cache = {};
                return collide(a, b, forgotten.call(pair, law, h));
            });
            ASSERT_TRUE(same_bits(with.i, without.i) && same_bits(with.j, without.j))
                << "run " << run << ", step " << step;
            touching_steps += with.contact.touches() ? 1 : 0;
        }
    }
    EXPECT_GT(touching_steps, 1000);
    EXPECT_LT(kernel_calls, 16 * 1500 / 2);
}

TEST(NodeContact, ForceAndTorquesBalance) {
    Random random(22, 0);
    const ContactLaw law = law_with(0.6, 0.3);
    int touching = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const SrShape& a = shape(trial % 4);
        const SrShape& b = shape(trial / 4 % 4);
        TwoBodies bodies = meeting(a, b, random);
        bodies.j.position *= random.uniform(0.6, 1.0);
        const PairState pair = bodies.pair();
        const PairContact c = first_touch(a, b, pair, law);
        if (!c.touches()) continue;
        ++touching;
        // About the center of i: the force on j is -force.
        const Vec3 total = c.torque_i + c.torque_j - pair.displacement.cross(c.force);
        EXPECT_LT(total.norm(), 1e-12 * c.force.norm() * a.bounding_radius);
    }
    EXPECT_GT(touching, 100);
}

/// How far the surface sinks between two nodes of a round shape: the error of its overlaps.
constexpr double node_dip = 4e-5;

PairState at(const Vec3& displacement, const Quat& j = Quat::Identity()) {
    PairState pair;
    pair.displacement = displacement;
    pair.i.inverse_inertia = solid_sphere(1200.0, 5e-3);
    pair.j.orientation = j;
    return pair;
}

template <class Wall>
void expect_like_a_sphere(const Wall& wall, const PairState& pair, const ContactLaw& law) {
    PointHistory history;
    const PairContact exact =
        collide(Sphere{5e-3}, wall, Call{pair, law, 1e-6, memory_of(history)});
    const PairContact by_nodes = first_touch(round_shape(), wall, pair, law);
    ASSERT_EQ(exact.touches(), by_nodes.touches());
    if (!exact.touches()) return;
    EXPECT_NEAR(by_nodes.overlap, exact.overlap, node_dip);
    EXPECT_GT(by_nodes.force.normalized().dot(exact.force.normalized()), 0.995);
}

TEST(NodeContact, ARoundShapeMeetsEveryWallAsASphereDoes) {
    Random random(23, 0);
    ContactLaw law = law_with(1.0, 0.0);
    law.geometry.multi_contact =
        ContactLaw::MultiContact::deepest;  // its overlap is that of one node
    for (int trial = 0; trial < 100; ++trial) {
        const Quat q = random.orientation();
        const Vec3 axis = q * Vec3::UnitZ();
        const Vec3 across = axis.unitOrthogonal();
        const double depth = random.uniform(-3e-4, 6e-4);
        if (std::abs(depth) < 1e-4) continue;
        const double height = 5e-3 - depth;
        expect_like_a_sphere(PlaneWall{}, at(-height * axis, q), law);
        expect_like_a_sphere(PlaneWall{2e-3}, at(-height * axis + 1e-3 * across, q), law);
        expect_like_a_sphere(PlaneWall{2e-3}, at(height * axis, q), law);
        expect_like_a_sphere(CylinderWall{0.02}, at((0.015 + depth) * across, q), law);
        expect_like_a_sphere(CylinderWall{0.02, 0.05},
                             at((0.015 + depth) * across - 0.02 * axis, q), law);
        expect_like_a_sphere(CylinderWall{0.02, 0.05, false},
                             at((0.025 - depth) * across - 0.02 * axis, q), law);
        expect_like_a_sphere(CylinderWall{0.02, 0.05, false}, at(height * axis + 1e-3 * across, q),
                             law);
    }
}

TEST(NodeContact, ASmallSphereTouchesWhereItsCenterIsNearest) {
    Random random(24, 0);
    const ContactLaw law = law_with(1.0, 0.0);
    const double radius = 1e-3;
    ASSERT_LT(radius, shape(0).sdf.margin);
    int touching = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const double gap = random.uniform(-1e-4, 1e-4);
        const double t = random.uniform(-1.5, 1.5);
        // Along the normal of the spheroid at a known point.
        const Vec3 foot(6.585e-3 * std::cos(t), 0.0, 3.395e-3 * std::sin(t));
        const Vec3 normal = Vec3(std::cos(t) / 6.585, 0.0, std::sin(t) / 3.395).normalized();
        const Vec3 center = foot + (radius + gap) * normal;
        const PairContact c = first_touch(Sphere{radius}, shape(0), at(-center), law);
        if (std::abs(gap) > 5e-6) {
            EXPECT_EQ(c.touches(), gap < 0.0);
        }
        if (!c.touches()) continue;
        ++touching;
        EXPECT_NEAR(c.overlap, -gap, 5e-6);
        EXPECT_GT(c.force.normalized().dot(normal), 0.998);
        EXPECT_LT(c.torque_i.norm(), 1e-9 * c.force.norm() * radius);
    }
    EXPECT_GT(touching, 50);
}

TEST(NodeContact, ALargeSphereRestsOnTheWholeRimOfAHollow) {
    const ContactLaw law = law_with(1.0, 0.0);
    const SrShape& cell = shape(3);
    const Sphere sphere{6e-3};
    ASSERT_GT(sphere.radius, cell.sdf.margin);
    // Down the axis until it touches.
    double height = sphere.radius + cell.bounding_radius;
    PairContact c;
    do {
        height -= 1e-5;
        c = first_touch(sphere, cell, at({0.0, 0.0, -height}), law);
    } while (!c.touches());
    ASSERT_GT(height - sphere.radius, cell.top_z);  // on the rim, above the bottom of the hollow
    c = first_touch(sphere, cell, at({0.0, 0.0, 1e-4 - height}), law);
    EXPECT_GT(c.points, 10U);
    EXPECT_LT(c.force.head<2>().norm(), 0.05 * std::abs(c.force.z()));
    // A little aside the rim pushes it back to the axis.
    c = first_touch(sphere, cell, at({-2e-4, 0.0, 1e-4 - height}), law);
    EXPECT_LT(c.force.x(), 0.0);
}

TEST(NodeContact, TheCurvatureTableGivesTheCurvatureOfTheNearestPoint) {
    Random random(25, 0);
    const double a = 6.585e-3;
    const double c = 3.395e-3;
    for (int trial = 0; trial < 300; ++trial) {
        const double t = random.uniform(-1.45, 1.45);
        const double w = std::sqrt(square(a * std::sin(t)) + square(c * std::cos(t)));
        const Vec2 normal = Vec2(c * std::cos(t), a * std::sin(t)) / w;
        const Vec2 x =
            Vec2(a * std::cos(t), c * std::sin(t)) + random.uniform(-2e-4, 2e-4) * normal;
        const double exact = 0.5 * (a * c / cube(w) + c / (a * w));
        EXPECT_NEAR(mean_curvature_near(shape(0), x.x(), x.y(), normal.x(), normal.y()) / exact,
                    1.0, 0.02);
    }
    EXPECT_DOUBLE_EQ(contact_curvature(0.0, 2.0), 0.1);
    EXPECT_DOUBLE_EQ(contact_curvature(-3.0, 2.0), 0.1);
    EXPECT_DOUBLE_EQ(contact_curvature(1e9, 2.0), 50.0);
}

TEST(NodeContact, PairsFarApartAreClearForAsLongAsTheyAreProvenToBe) {
    Fresh fresh;
    const SrShape& a = shape(2);
    PairState pair = at({0.1, 0.0, 0.0});
    EXPECT_FALSE(collide(a, a, fresh.call(pair, law_with(1.0, 0.0), 1e-6)).touches());
    EXPECT_LT(0.0999 - 2.0 * a.bounding_radius, fresh.cache.clear_until);
    EXPECT_GE(0.1, fresh.cache.clear_until);
}

}  // namespace
}  // namespace dem::test
