// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/law/patch_slots.hpp"

#include <algorithm>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

PairState moving_pair(std::uint64_t seed) {
    Random random(21, seed);
    PairState pair;
    pair.displacement = 9e-3 * Vec3::UnitZ();
    for (BodyState* b : {&pair.i, &pair.j}) {
        b->orientation = random.orientation();
        b->velocity = 0.3 * random.direction();
        b->angular_velocity = 20.0 * random.direction();
        b->inverse_inertia = {1.0 / 6e-4, Vec3(1e8, 1.5e8, 2e8)};
    }
    return pair;
}

std::vector<ContactPoint> points_near_the_middle(std::size_t count, std::uint64_t seed) {
    Random random(22, seed);
    std::vector<ContactPoint> points;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 at(random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3), 4.5e-3);
        const Vec3 gradient =
            (Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), -1.0)).normalized();
        points.push_back({at, gradient, random.uniform(1e-6, 1e-5), 10 * k});
    }
    return points;
}

ContactLaw rough_law() {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    return law;
}

void expect_same(const PairContact& a, const PairContact& b, double tolerance) {
    EXPECT_LT((a.force - b.force).norm(), tolerance * a.force.norm());
    EXPECT_LT((a.torque_i - b.torque_i).norm(), tolerance * a.torque_i.norm());
    EXPECT_LT((a.torque_j - b.torque_j).norm(), tolerance * a.torque_j.norm());
    EXPECT_NEAR(a.elastic_energy, b.elastic_energy, tolerance * a.elastic_energy);
    EXPECT_NEAR(a.dissipated_energy, b.dissipated_energy,
                tolerance * std::abs(a.dissipated_energy));
}

TEST(PatchForce, OnePointIsPlainHertzInEveryMode) {
    using Multi = ContactLaw::MultiContact;
    for (const Multi mode : {Multi::norm, Multi::sum, Multi::deepest}) {
        ContactLaw law = rough_law();
        law.geometry.multi_contact = mode;
        PatchHistory patch;
        PointHistory single;
        for (std::uint64_t step = 0; step < 20; ++step) {
            const PairState pair = moving_pair(3);
            ContactPoint point = points_near_the_middle(1, 5).front();
            point.overlap += 1e-7 * static_cast<double>(step);
            const PairContact a = contact_force(point, 2e-3, pair, law, 1e-6, single);
            const PairContact b = contact_force(std::span(&point, 1), 2e-3, pair, law, 1e-6, patch);
            expect_same(a, b, 1e-12);
        }
    }
}

TEST(PatchForce, ManyPointsInOnePlaceActAsOne) {
    const ContactLaw law = rough_law();
    const PairState pair = moving_pair(4);
    const ContactPoint point = points_near_the_middle(1, 6).front();
    PointHistory single;
    const PairContact expected = contact_force(point, 2e-3, pair, law, 1e-6, single);
    for (const std::size_t count : {2U, 16U, 50U}) {
        std::vector<ContactPoint> points(count, point);
        for (std::size_t k = 0; k < count; ++k) points[k].feature = k;
        PatchHistory patch;
        const PairContact c = contact_force(points, 2e-3, pair, law, 1e-6, patch);
        // d = N^(1/16) delta: stiffness within 28 % for 50 points, not 50 times.
        const double growth = std::pow(static_cast<double>(count), 1.0 / 16.0);
        EXPECT_NEAR(c.overlap, growth * point.overlap, 1e-12 * point.overlap);
        EXPECT_NEAR(c.elastic_energy, std::pow(growth, 2.5) * expected.elastic_energy,
                    0.02 * expected.elastic_energy);
        EXPECT_LT(c.force.normalized().cross(expected.force.normalized()).norm(), 0.05);
    }
}

TEST(PatchForce, NormalForceIsTheGradientOfTheElasticEnergy) {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);
    PairState pair = moving_pair(7);
    const std::vector<ContactPoint> points = points_near_the_middle(20, 8);
    const auto energy_after = [&](const Vec3& shift) {
        std::vector<ContactPoint> moved = points;
        for (ContactPoint& p : moved) p.overlap -= p.gradient.dot(shift);
        PatchHistory history;
        return contact_force(moved, 2e-3, pair, law, 1e-6, history).elastic_energy;
    };
    PatchHistory history;
    const PairContact c = contact_force(points, 2e-3, pair, law, 1e-6, history);
    const double h = 1e-10;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 e = h * Vec3::Unit(axis);
        EXPECT_NEAR((energy_after(-e) - energy_after(e)) / (2.0 * h), c.force[axis],
                    1e-6 * c.force.norm());
    }
}

TEST(PatchForce, FrictionOfManyPointsStaysWithinTheCoulombLimit) {
    const ContactLaw law = rough_law();
    PairState pair = moving_pair(9);
    pair.i.velocity = {2.0, 0.0, 0.0};
    pair.j.velocity = Vec3::Zero();
    pair.i.angular_velocity = pair.j.angular_velocity = Vec3::Zero();
    for (const std::size_t count : {3U, 16U, 60U}) {
        std::vector<ContactPoint> points = points_near_the_middle(count, 10);
        for (ContactPoint& p : points) p.gradient = -Vec3::UnitZ();
        PatchHistory history;
        PairContact c;
        for (int k = 0; k < 100; ++k) c = contact_force(points, 2e-3, pair, law, 1e-6, history);
        EXPECT_NEAR(-c.force.x(), law.friction * std::abs(c.force.z()), 1e-9 * c.force.norm());
    }
}

TEST(PatchForce, FrictionOfManyPointsIsCutAtTheElasticPartOfTheirForces) {
    PairState pair = moving_pair(9);
    pair.i.velocity = {2.0, 0.0, 0.2};  // sliding and parting
    pair.j.velocity = Vec3::Zero();
    pair.i.angular_velocity = pair.j.angular_velocity = Vec3::Zero();
    using Multi = ContactLaw::MultiContact;
    for (const Multi mode : {Multi::norm, Multi::sum, Multi::deepest}) {
        for (const std::size_t count : {1U, 3U, 16U, 60U}) {
            std::vector<ContactPoint> points = points_near_the_middle(count, 10);
            for (ContactPoint& p : points) p.gradient = Vec3::UnitZ();
            const auto sliding_force = [&](double restitution) {
                ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, restitution);
                law.friction = 0.3;
                law.geometry.multi_contact = mode;
                PatchHistory history;
                Vec3 force;
                for (int k = 0; k < 100; ++k)
                    force = contact_force(points, 2e-3, pair, law, 1e-6, history).force;
                return force;
            };
            const Vec3 elastic = sliding_force(1.0);
            const Vec3 damped = sliding_force(0.4);
            EXPECT_LT(damped.z(), 0.5 * elastic.z());
            EXPECT_NEAR(-damped.x(), 0.3 * elastic.z(), 1e-9 * elastic.z()) << count;
        }
    }
}

// Eight springs stand for all: they must not turn the body because of where they happen to lie.
TEST(PatchForce, FrictionOfManyPointsActsWhereTheirLoadDoes) {
    PairState pair = moving_pair(9);
    pair.i.velocity = {0.05, 0.02, 0.0};
    pair.j.velocity = Vec3::Zero();
    pair.i.angular_velocity = pair.j.angular_velocity = Vec3::Zero();
    using Multi = ContactLaw::MultiContact;
    for (const Multi mode : {Multi::norm, Multi::sum}) {
        ContactLaw law = rough_law();
        law.geometry.multi_contact = mode;
        std::vector<ContactPoint> points = points_near_the_middle(60, 10);
        std::sort(points.begin(), points.end(), [](const ContactPoint& a, const ContactPoint& b) {
            return a.position.x() < b.position.x();
        });
        Vec3 center = Vec3::Zero();
        for (std::size_t k = 0; k < points.size(); ++k) {
            points[k].gradient = -Vec3::UnitZ();
            points[k].overlap = 1e-5;
            points[k].feature = k;
            center += points[k].position / static_cast<double>(points.size());
        }
        PatchHistory history;  // held by the eight at one end
        contact_force(std::span(points).first(8), 2e-3, pair, law, 1e-6, history);
        PairContact c;
        for (int step = 0; step < 200; ++step)
            c = contact_force(points, 2e-3, pair, law, 1e-6, history);  // until all slide
        const Vec3 turn = c.torque_i - center.cross(c.force);
        EXPECT_LT(std::abs(turn.z()), 1e-12 * c.force.norm());
        EXPECT_NEAR(c.force.head<2>().norm(), law.friction * std::abs(c.force.z()),
                    1e-9 * c.force.norm());
    }
}

TEST(PatchForce, LosingContactClearsTheHistory) {
    PatchHistory history;
    const PairState pair = moving_pair(1);
    contact_force(points_near_the_middle(5, 1), 2e-3, pair, rough_law(), 1e-6, history);
    EXPECT_EQ(history.used, 5U);
    EXPECT_FALSE(contact_force({}, 2e-3, pair, rough_law(), 1e-6, history).touches());
    const PatchHistory empty;
    EXPECT_EQ(std::memcmp(&history, &empty, sizeof history), 0);
}

TEST(PatchSlots, KeepTouchingPointsAndGiveTheRestToTheDeepest) {
    Random random(31, 1);
    PatchHistory history;
    std::set<std::uint64_t> had;
    for (int step = 0; step < 200; ++step) {
        std::vector<ContactPoint> points;
        for (std::uint64_t feature = 0; feature < 60; ++feature)
            if (random.uniform() < 0.6)
                points.push_back(
                    {Vec3::Zero(), Vec3::UnitZ(), std::floor(random.uniform(1.0, 20.0)), feature});
        const PatchSlots slots = choose_slots(points, history);

        std::set<std::uint64_t> expected;
        for (const ContactPoint& p : points)
            if (had.contains(p.feature)) expected.insert(p.feature);
        std::vector<ContactPoint> others;
        for (const ContactPoint& p : points)
            if (!had.contains(p.feature)) others.push_back(p);
        std::stable_sort(others.begin(), others.end(),
                         [](const auto& a, const auto& b) { return a.overlap > b.overlap; });
        for (const ContactPoint& p : others)
            if (expected.size() < PatchHistory::slot_count) expected.insert(p.feature);

        std::set<std::uint64_t> chosen;
        for (std::size_t k = 0; k < slots.count; ++k) {
            const std::uint64_t feature = points[slots.point[k]].feature;
            EXPECT_TRUE(chosen.empty() || feature > *chosen.rbegin());
            EXPECT_EQ(slots.known[k], had.contains(feature));
            if (slots.known[k]) {
                EXPECT_EQ(history.slots[k].feature, feature);
            }
            chosen.insert(feature);
            history.slots[k].feature = feature;
        }
        history.used = slots.count;
        EXPECT_EQ(chosen, expected);
        had = chosen;
    }
}

}  // namespace
}  // namespace dem::runtime
