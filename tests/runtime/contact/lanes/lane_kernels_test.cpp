// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/lanes/lane_kernels.hpp"

#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "tests/runtime/contact/lanes/lane_contacts.hpp"

#include <vector>

#include <gtest/gtest.h>

// The promise of docs/lanes.md: a contact in a lane has the bits of the same contact by itself.

namespace dem::test {

using namespace runtime;

namespace {

template <class Shape, class Cache>
struct Encounter {
    const LaneTestBody<Shape>*a, *b;
    PairState pair;
    PointHistory history;
    Cache cache;
    LaneRow i, j;
    PairResult result;
    bool touches = false;
};

/// Two bodies that just overlap, drifting slowly along and about each other.
template <class Shape, class Cache>
Encounter<Shape, Cache> encounter(const std::vector<LaneTestBody<Shape>>& bodies,
                                  const ContactLaw& law, Random& random) {
    Encounter<Shape, Cache> e{&bodies[random.next() % bodies.size()],
                              &bodies[random.next() % bodies.size()],
                              {},
                              {},
                              {},
                              {},
                              {},
                              {},
                              false};
    for (BodyState* state : {&e.pair.i, &e.pair.j}) {
        state->orientation = random.orientation();
        state->velocity = 0.05 * random.direction();
        state->angular_velocity = 5.0 * random.direction();
    }
    e.pair.i.inverse_inertia = e.a->inertia;
    e.pair.j.inverse_inertia = e.b->inertia;
    const Vec3 direction = random.direction();
    const double depth = random.uniform(1e-6, 1e-4);
    // Down to where they touch, then a little farther.
    double far = e.a->kind.radius + e.b->kind.radius;
    double near = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (far + near);
        e.pair.displacement = middle * direction;
        PointHistory history;
        Cache cache;
        const bool touches =
            collide(e.a->shape, e.b->shape, Call{e.pair, law, 1e-6, Memory{history, cache}})
                .touches();
        (touches ? near : far) = middle;
    }
    e.pair.displacement = (near - depth) * direction;
    return e;
}

/// Steps of many encounters at once, by collide() and by the kernel from the same state.
template <class Cache, class Shape>
Count compare(const std::vector<LaneTestBody<Shape>>& bodies, const ContactLaw& law,
              LaneKernel kernel, std::uint64_t seed) {
    constexpr double dt = 2e-7;
    Random random(seed, 1);
    std::vector<Encounter<Shape, Cache>> all;
    all.reserve(61);
    for (int n = 0; n < 61; ++n) all.push_back(encounter<Shape, Cache>(bodies, law, random));
    Count count;
    for (int step = 0; step < 300; ++step) {
        std::vector<LaneContact> contacts;
        std::vector<std::size_t> of;
        std::vector<PointHistory> before;
        for (std::size_t n = 0; n < all.size(); ++n) {
            auto& e = all[n];
            move(e.pair, dt);
            e.i = row(Vec3::Zero(), e.pair.i);
            e.j = row(e.pair.displacement, e.pair.j);
            if (!e.history.touched()) continue;
            contacts.push_back(
                {&e.i, &e.j, &e.a->kind, &e.b->kind, &law, &e.history, &e.history, &e.result});
            of.push_back(n);
            before.push_back(e.history);
        }
        LaneOutcome outcome;
        kernel(contacts, dt, outcome);
        std::size_t next = 0;
        for (std::size_t n = 0; n < all.size(); ++n) {
            auto& e = all[n];
            const bool in_lane = next < of.size() && of[next] == n;
            PointHistory history = in_lane ? before[next] : e.history;
            const PairContact c =
                collide(e.a->shape, e.b->shape, Call{e.pair, law, dt, Memory{history, e.cache}});
            if (in_lane && (outcome.done >> next & 1) != 0) {
                ++count.in_lanes;
                expect_same(e.result, outcome.overlap[next], c);
                EXPECT_TRUE(same_bytes(history, e.history));
            } else if (in_lane) {
                ++count.rare;
                EXPECT_TRUE(same_bytes(before[next], e.history));
            }
            e.history = history;
            next += in_lane ? 1 : 0;
            if (testing::Test::HasFailure()) return count;
        }
    }
    return count;
}

class LaneKernelsTest : public testing::TestWithParam<int> {
  protected:
    const LaneKernels* kernels() const { return lane_kernels(GetParam()); }
};

TEST_P(LaneKernelsTest, SpheresHaveTheBitsOfOneAtATime) {
    if (kernels() == nullptr) GTEST_SKIP() << "not on this processor";
    const std::vector<LaneTestBody<Sphere>> bodies{body(2e-3), body(3e-3), body(5e-3)};
    for (std::size_t k = 0; k < laws().size(); ++k) {
        const Count count = compare<NoCache>(bodies, laws()[k], kernels()->spheres, 10 + k);
        EXPECT_GT(count.in_lanes, 10'000) << "law " << k;
        EXPECT_LT(count.rare, 100) << "law " << k;
    }
}

TEST_P(LaneKernelsTest, SurfacesOfRevolutionHaveTheBitsOfOneAtATime) {
    if (kernels() == nullptr) GTEST_SKIP() << "not on this processor";
    std::vector<LaneTestBody<SrShape>> bodies{body(candy()), body(tablet()),
                                              body(cylinder(4e-3, 6e-3))};
    for (auto& b : bodies) b.kind.support = &b.shape.support;
    for (std::size_t k = 0; k < laws().size(); ++k) {
        const Count count = compare<MissCache>(bodies, laws()[k], kernels()->smooth, 20 + k);
        EXPECT_GT(count.in_lanes, 2'000) << "law " << k;
        RecordProperty("rare_" + std::to_string(k), count.rare);
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, LaneKernelsTest, testing::Values(2, 4, 8));

}  // namespace
}  // namespace dem::test
