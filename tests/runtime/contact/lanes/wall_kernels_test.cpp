// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/lanes/one_point.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/walls/wall_work.hpp"
#include "tests/runtime/contact/lanes/lane_contacts.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

// The promise of docs/lanes.md for contacts with walls, which move.

namespace dem::test {

using namespace runtime;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

template <class Wall>
struct LaneTestWall {
    Wall shape;
    LaneKind kind;
};

/// Of infinite size and small enough for bodies to reach beyond the rim.
std::vector<LaneTestWall<PlaneWall>> planes() {
    std::vector<LaneTestWall<PlaneWall>> all(2);
    all[1].shape.radius = 4e-3;
    for (auto& wall : all) wall.kind.radius = wall.shape.radius;
    return all;
}
std::vector<LaneTestWall<CylinderWall>> tubes() {
    std::vector<LaneTestWall<CylinderWall>> all(3);
    all[0].shape = {25e-3, endless, true};
    all[1].shape = {16e-3, 12e-3, true};
    all[2].shape = {40e-3, 50e-3, true};
    for (auto& wall : all) {
        wall.kind.radius = wall.shape.radius;
        wall.kind.length = wall.shape.length;
    }
    return all;
}

/// A place of the body in the wall's frame, `reach` from its surface.
Vec3 place_at(const PlaneWall& /*wall*/, double reach, Random& random) {
    return {random.uniform(-3e-3, 3e-3), random.uniform(-3e-3, 3e-3), reach};
}
Vec3 place_at(const CylinderWall& wall, double reach, Random& random) {
    const double angle = random.uniform(0.0, 2.0 * pi);
    return {(wall.radius - reach) * std::cos(angle), (wall.radius - reach) * std::sin(angle),
            random.uniform(0.0, 12e-3)};
}

template <class Shape, class Wall, class History, class Cache>
struct WallEncounter {
    const LaneTestBody<Shape>* body;
    const LaneTestWall<Wall>* wall;
    PairState pair;
    History history{};
    Cache cache{};
    LaneRow i{}, j{};
    PairResult result{};

    PairContact collide_alone(const ContactLaw& law, double dt, History& memory) {
        return collide(body->shape, wall->shape, Call{pair, law, dt, Memory{memory, cache}});
    }
};

/// A body that overlaps a wall a little; both drift and turn slowly.
template <class Of, class Bodies, class Walls>
Of encounter(const Bodies& bodies, const Walls& walls, const ContactLaw& law, Random& random) {
    Of e{&bodies[random.next() % bodies.size()], &walls[random.next() % walls.size()], {}};
    for (BodyState* state : {&e.pair.i, &e.pair.j}) {
        state->orientation = random.orientation();
        state->velocity = 0.05 * random.direction();
        state->angular_velocity = 5.0 * random.direction();
    }
    e.pair.i.inverse_inertia = e.body->inertia;
    const Random at = random;
    const auto put = [&](double reach) {
        Random same_place = at;
        e.pair.displacement = -(e.pair.j.orientation * place_at(e.wall->shape, reach, same_place));
    };
    double far = e.body->kind.radius;
    double near = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (far + near);
        put(middle);
        auto memory = e.history;
        (e.collide_alone(law, 1e-6, memory).touches() ? near : far) = middle;
    }
    e.cache = {};
    put(near - random.uniform(1e-6, 1e-4));
    return e;
}

/// Steps of many encounters at once, by collide() and by the kernel from the same state.
template <class History, class Cache, class Shape, class Wall>
Count compare(const std::vector<LaneTestBody<Shape>>& bodies,
              const std::vector<LaneTestWall<Wall>>& walls, const ContactLaw& law,
              LaneKernel kernel, std::uint64_t seed) {
    using Of = WallEncounter<Shape, Wall, History, Cache>;
    constexpr double dt = 2e-7;
    Random random(seed, 1);
    std::vector<Of> all;
    all.reserve(61);
    for (int n = 0; n < 61; ++n) all.push_back(encounter<Of>(bodies, walls, law, random));
    Count count;
    for (int step = 0; step < 300 && !testing::Test::HasFailure(); ++step) {
        std::vector<LaneContact> contacts;
        std::vector<Of*> in_lanes;
        std::vector<History> before;
        for (Of& e : all) {
            move(e.pair, dt);
            e.i = row(Vec3::Zero(), e.pair.i);
            e.j = row(e.pair.displacement, e.pair.j);
            if (!e.history.touched() || !is_one_point(e.history)) {
                e.collide_alone(law, dt, e.history);
                continue;
            }
            contacts.push_back({&e.i, &e.j, &e.body->kind, &e.wall->kind, &law, &e.history,
                                &spring_of(e.history), &e.result});
            in_lanes.push_back(&e);
            before.push_back(e.history);
        }
        LaneOutcome outcome;
        kernel(contacts, dt, outcome);
        for (std::size_t n = 0; n < in_lanes.size(); ++n) {
            Of& e = *in_lanes[n];
            History history = before[n];
            const PairContact c = e.collide_alone(law, dt, history);
            if ((outcome.done >> n & 1) != 0) {
                ++count.in_lanes;
                share_normal(e.history);
                expect_same(e.result, outcome.overlap[n], c);
                EXPECT_EQ(e.result.wall_work, wall_work(e.pair, c, dt));
                EXPECT_TRUE(same_bytes(history, e.history));
            } else {
                ++count.rare;
                EXPECT_TRUE(same_bytes(before[n], e.history));
                e.history = history;
            }
        }
    }
    return count;
}

std::vector<LaneTestBody<Sphere>> spheres() {
    return {body(2e-3), body(3e-3), body(5e-3)};
}
std::vector<LaneTestBody<SrShape>> smooth_bodies() {
    std::vector<LaneTestBody<SrShape>> bodies{
        body(candy()), body(tablet()), body(cylinder(4e-3, 6e-3)), body(spheroid(2.5e-3, 5e-3))};
    for (auto& b : bodies) b.kind.support = &b.shape.support;
    return bodies;
}

class WallKernelsTest : public testing::TestWithParam<int> {
  protected:
    void SetUp() override {
        if (lane_kernels(GetParam()) == nullptr) GTEST_SKIP() << "not on this processor";
    }

    template <class History, class Cache, class Bodies, class Walls>
    void expect_the_bits_of_one_at_a_time(const Bodies& bodies, const Walls& walls,
                                          LaneKernel LaneKernels::*kernel, int at_least) {
        std::uint64_t seed = 30;
        for (const ContactLaw& law : laws()) {
            const Count count = compare<History, Cache>(bodies, walls, law,
                                                        lane_kernels(GetParam())->*kernel, ++seed);
            EXPECT_GT(count.in_lanes, at_least) << "law " << seed - 30;
            RecordProperty("in_lanes_" + std::to_string(seed - 30), count.in_lanes);
            RecordProperty("rare_" + std::to_string(seed - 30), count.rare);
        }
    }
};

TEST_P(WallKernelsTest, SpheresAtPlanesAndDiscsHaveTheBitsOfOneAtATime) {
    expect_the_bits_of_one_at_a_time<PointHistory, NoCache>(spheres(), planes(),
                                                            &LaneKernels::sphere_at_plane, 10'000);
}

TEST_P(WallKernelsTest, SpheresInTubesHaveTheBitsOfOneAtATime) {
    expect_the_bits_of_one_at_a_time<PointHistory, NoCache>(spheres(), tubes(),
                                                            &LaneKernels::sphere_in_tube, 10'000);
}

TEST_P(WallKernelsTest, SurfacesOfRevolutionAtPlanesAndDiscsHaveTheBitsOfOneAtATime) {
    const auto bodies = smooth_bodies();
    expect_the_bits_of_one_at_a_time<PointHistory, MissCache>(bodies, planes(),
                                                              &LaneKernels::smooth_at_plane, 5'000);
}

TEST_P(WallKernelsTest, SurfacesOfRevolutionInTubesHaveTheBitsOfOneAtATime) {
    const auto bodies = smooth_bodies();
    expect_the_bits_of_one_at_a_time<PatchHistory, MissCache>(bodies, tubes(),
                                                              &LaneKernels::smooth_in_tube, 5'000);
}

INSTANTIATE_TEST_SUITE_P(Widths, WallKernelsTest, testing::Values(2, 4, 8));

}  // namespace
}  // namespace dem::test
