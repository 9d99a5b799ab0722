// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/checkpoint/state_archive.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "runtime/walls/pose_table.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/sample_walls.hpp"

#include <functional>
#include <memory>

#include <gtest/gtest.h>

// The promise of docs/time-loop.md: the state after any number of steps has the same bits for any
// number of threads, any skin and across any number of restarts.

namespace dem::runtime {

using namespace shapegen;

namespace {

struct NamedScene {
    const char* name;
    std::function<Scene()> make;
    double dt;
    int steps;
};

std::ostream& operator<<(std::ostream& out, const NamedScene& scene) {
    return out << scene.name;
}

// Polydisperse spheres with friction fall into a box whose floor shakes.
Scene polydisperse_spheres() {
    Scene scene = scenes::one_material({1e8, 2000.0, 0.5, 0.4});
    for (const double radius : {1e-3, 2e-3, 5e-3}) scenes::add_kind(scene, scenes::sphere(radius));
    std::vector<BodyPlacement> bodies;
    for (std::uint32_t n = 0; n < 700; ++n) {
        Random random(3, n);
        BodyPlacement body;
        body.kind = n % 50 == 0 ? 2 : n % 5 == 0 ? 1 : 0;
        const double cell = body.kind == 2 ? 10.2e-3 : 5e-3;
        body.position = {cell * (n % 6) + 3e-3, cell * (n / 6 % 6) + 3e-3, cell * (n / 36) + 6e-3};
        if (body.kind == 2)
            body.position = {8e-3 + 11e-3 * (n % 100 == 0 ? 0 : 1), 12e-3, 0.12 + 12e-3 * n / 50};
        body.position += 2e-4 * random.direction();
        body.velocity = 0.5 * random.direction() - Vec3(0.0, 0.0, 1.0);
        body.angular_velocity = 50.0 * random.direction();
        bodies.push_back(body);
    }
    scene.insertions.push_back(scenes::placed(bodies));
    scenes::add_box(scene, {-1e-3, -1e-3, 0.0}, {34e-3, 34e-3, 0.5});
    MotionPiece& shake = scene.walls[4].motion.pieces.emplace_back();
    shake.kind = MotionPiece::Kind::oscillate;
    shake.axis = Vec3::UnitZ();
    shake.amplitude = 1e-3;
    shake.frequency = 40.0;
    return scene;
}

/// The same, where the ground opens in two corners and a plane counts what falls on.
Scene spheres_that_run_out() {
    Scene scene = polydisperse_spheres();
    const double middle = 16e-3;
    scene.outlets.push_back({.name = "drain",
                             .where = "test.ini:1",
                             .place = BoxRegion{{{middle, middle, -1.0}, {1.0, 1.0, 6e-3}}}});
    scene.outlets.push_back({.name = "pit",
                             .where = "test.ini:2",
                             .place = CylinderRegion{{0.0, 0.0, -1.0}, {0.0, 0.0, 4e-3}, 10e-3}});
    scene.outlets.push_back({.name = "gate",
                             .where = "test.ini:3",
                             .kind = Outlet::Kind::flow,
                             .place = HalfSpace{{0.0, 0.0, 0.03}, {0.0, 0.0, -1.0}}});
    return scene;
}

// Equal spheres poured in batches into a vessel that turns.
Scene batches_into_a_turning_vessel() {
    Scene scene = scenes::one_material({1e8, 2000.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::sphere(2e-3));
    InsertionGroup group;
    group.name = "pour";
    group.where = "test.ini:1";
    group.mode = InsertionGroup::Mode::batches;
    group.kinds = {0};
    group.count = 300;
    group.batch = 60;
    group.every = 0.006;
    group.region = CylinderRegion{{0.0, 0.0, 0.02}, {0.0, 0.0, 0.05}, 14e-3};
    group.velocity = {0.0, 0.0, -1.5};
    scene.insertions.push_back(group);
    scenes::add_vessel(scene, 15e-3);
    for (Wall& wall : scene.walls) {
        wall.motion.pieces = {{.kind = MotionPiece::Kind::rotate,
                               .axis = Vec3(0.1, 0.0, 1.0).normalized(),
                               .rate = 20.0,
                               .from = 0.015}};
    }
    return scene;
}

/// `count` bodies of the first `kinds` kinds, falling into a vessel that soon begins to turn.
void pour_into_turning_vessel(Scene& scene, std::uint32_t count, std::uint32_t kinds) {
    std::vector<BodyPlacement> bodies = scenes::column(count, kinds, 25e-3, 13.5e-3);
    for (BodyPlacement& body : bodies) body.velocity = {0.3, 0.2, -1.5};
    scene.insertions.push_back(scenes::placed(bodies));
    scenes::add_vessel(scene, 25e-3);
    for (Wall& wall : scene.walls) {
        wall.motion.pieces = {{.kind = MotionPiece::Kind::rotate, .rate = 15.0, .from = 0.005}};
    }
}

// Candies, peanuts and spheres fall into a vessel that turns: every pair of kinds.
Scene mixture(ContactLaw::Method method) {
    ContactLaw options;
    options.geometry.method = method;
    Scene scene = scenes::one_material({2e7, 1400.0, 0.5, 0.3, options});
    static const ParticleTemplate candy = scenes::candy(600);  // slow to make
    static const ParticleTemplate peanut = scenes::peanut(600);
    scenes::add_kind(scene, candy);
    scenes::add_kind(scene, peanut);
    scenes::add_kind(scene, scenes::sphere(5e-3));
    pour_into_turning_vessel(scene, 60, 3);
    return scene;
}
Scene continuous_mixture() {
    return mixture(ContactLaw::Method::continuous);
}
Scene node_mixture() {
    return mixture(ContactLaw::Method::nodes);
}

// Tablets with sharp edges, which touch the side of the vessel in one place or two.
Scene tablets() {
    Scene scene = scenes::one_material({1e8, 1400.0, 0.5, 0.3});
    scenes::add_kind(scene, scenes::tablet());
    pour_into_turning_vessel(scene, 60, 1);
    scene.walls[0].shape = CylinderWall{25e-3, 0.3};
    scene.walls[1].motion.pieces[0].point = {5e-3, 0.0, 0.0};
    scene.run.overlap_limit = 0.3;
    return scene;
}

// Clumps among candies, peanuts and spheres: every pair of kinds that has a clump in it.
Scene clump_mixture() {
    Scene scene = scenes::one_material({2e7, 1400.0, 0.5, 0.3});
    static const ParticleTemplate candy = scenes::candy(600);
    static const ParticleTemplate peanut = scenes::peanut(600);
    scenes::add_kind(scene, scenes::candy_clump());
    scenes::add_kind(scene, peanut);
    scenes::add_kind(scene, scenes::dumbbell_clump());
    scenes::add_kind(scene, candy);
    scenes::add_kind(scene, scenes::sphere(4e-3));
    pour_into_turning_vessel(scene, 60, 5);
    return scene;
}

// Convex shapes of every kind among all others: every pair that has a convex shape in it.
Scene convex_mixture() {
    Scene scene = scenes::one_material({2e7, 1400.0, 0.5, 0.3});
    static const ParticleTemplate candy = scenes::candy(600);
    static const ParticleTemplate peanut = scenes::peanut(600);
    const double d = 9e-3;
    scenes::add_kind(scene, scenes::convex(make_cuboid(Vec3::Constant(0.8 * d), 0.02 * d)));
    scenes::add_kind(scene, scenes::convex(make_cylinder(0.45 * d, 0.9 * d, 0.02 * d)));
    scenes::add_kind(scene, candy);
    scenes::add_kind(scene, scenes::sand_grain(d, 20, 1));
    scenes::add_kind(scene, peanut);
    scenes::add_kind(scene, scenes::convex(make_ellipsoid(d * Vec3(0.7, 0.5, 0.35))));
    scenes::add_kind(scene, scenes::sphere(4e-3));
    scenes::add_kind(scene, scenes::convex(make_cone(0.5 * d, d, 0.02 * d)));
    scenes::add_kind(scene, scenes::dumbbell_clump());
    scenes::add_kind(scene, scenes::convex(make_capsule(0.3 * d, 1.2 * d)));
    pour_into_turning_vessel(scene, 50, 10);
    return scene;
}

// The same under the linear law, where nothing slips.
Scene mixture_without_slip() {
    Scene scene = convex_mixture();
    ContactLaw options;
    options.friction = 10.0;
    scene.laws.set(0, 0, linear_law(1e4, 0.7, 0.6, options));
    return scene;
}

// Spheres and clumps in a closed vessel of triangles that shakes, among the facets of a tube that
// turns and on a ridge.
Scene vessels_of_triangles() {
    Scene scene = scenes::one_material({2e7, 1400.0, 0.5, 0.3});
    scenes::add_kind(scene, scenes::sphere(4e-3));
    scenes::add_kind(scene, scenes::candy_clump());
    scenes::add_kind(scene, scenes::dumbbell_clump());
    std::vector<BodyPlacement> bodies = scenes::column(50, 3, 25e-3, 13.5e-3);
    for (BodyPlacement& body : bodies) {
        body.position.z() += 10e-3;
        body.velocity = {0.5, 0.4, -1.5};
    }
    scene.insertions.push_back(scenes::placed(bodies));
    const auto wall = [&](const char* name, const sample::Surface& surface) -> Wall& {
        Wall made;
        made.name = name;
        made.shape = MeshWall{std::make_shared<const WallMesh>(surface.wall())};
        scene.walls.push_back(made);
        return scene.walls.back();
    };
    Wall& box = wall("box", sample::box_inside({-0.035, -0.035, -0.01}, {0.035, 0.035, 0.3}));
    box.motion.pieces = {{.kind = MotionPiece::Kind::oscillate,
                          .axis = Vec3(0.3, 0.0, 1.0).normalized(),
                          .amplitude = 1e-3,
                          .frequency = 40.0}};
    Wall& tube = wall("tube", sample::tube(0.03, 0.005, 0.25, 60));
    tube.motion.pieces = {{.kind = MotionPiece::Kind::rotate, .rate = 15.0, .from = 0.005}};
    wall("ridge", sample::valley(-pi / 3.0, 0.02, 0.04));
    return scene;
}

/// A vessel that turns to and fro about an axis that a table moves, on a belt, once what fell into
/// it has settled.
Scene motions_after_rest() {
    Scene scene = scenes::one_material({2e6, 1000.0, 0.2, 0.5});
    scenes::add_kind(scene, scenes::sphere(4e-3));
    scene.insertions.push_back(scenes::placed(scenes::column(12, 1, 20e-3, 9e-3)));
    for (BodyPlacement& body : scene.insertions[0].placements) body.position.z() -= 0.3e-3;
    scenes::add_vessel(scene, 20e-3);
    auto nod = std::make_shared<Motion>();
    nod->pieces = {{.kind = MotionPiece::Kind::table, .until = 0.2}};
    nod->pieces[0].table = std::make_shared<const PoseTable>(std::vector<PoseTable::Row>{
        {0.0, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}},
        {0.05, {1e-3, 0.0, 2e-3}, Quat(1.0, 0.1, 0.1, 0.0).normalized()},
        {0.2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}});
    nod->from_settled = true;
    Motion turn;
    turn.pieces = {
        {.kind = MotionPiece::Kind::rotate, .rate = 20.0, .until = 0.02},
        {.kind = MotionPiece::Kind::rotate, .rate = -15.0, .from = 0.025, .until = 0.05}};
    turn.pieces[0].ramp = 0.015;
    turn.period = 0.06;
    turn.from_settled = true;
    turn.within = nod;
    for (Wall& wall : scene.walls) wall.motion = turn;
    scene.walls[1].surface_velocity = {0.05, 0.02, 0.0};
    return scene;
}

class SameBits : public testing::TestWithParam<NamedScene> {
  protected:
    using Threads = std::vector<int>;

    /// These threads, in turn from step to step, share every loop, however small.
    static Scene made(Threads threads) {
        Scene scene = GetParam().make();
        scene.run.forced_threads = std::move(threads);
        return scene;
    }

    static std::vector<std::uint64_t> hashes(Scene scene) {
        Simulation simulation(std::move(scene), GetParam().dt);
        std::vector<std::uint64_t> result;
        for (int step = 1; step <= GetParam().steps; ++step) {
            simulation.step();
            if (step % 100 == 0) result.push_back(simulation.state_hash());
        }
        EXPECT_GT(simulation.lists().rebuilds, 2U);
        EXPECT_GT(simulation.largest_overlap().relative, 0.0);
        return result;
    }
};

TEST_P(SameBits, ForAnyNumberOfThreadsAtAnyStep) {
    const auto expected = hashes(made({1}));
    for (const Threads& threads : {Threads{2}, Threads{3}, Threads{8}, Threads{1, 2, 3, 8, 1, 5}}) {
        EXPECT_EQ(hashes(made(threads)), expected) << testing::PrintToString(threads);
    }
}

TEST_P(SameBits, ForAnyNumberOfLanes) {
    const auto in_lanes = [](int lanes) {
        Scene scene = made({2});
        scene.run.lanes = lanes;
        return hashes(std::move(scene));
    };
    const auto expected = in_lanes(1);
    for (const int lanes : {2, 4, 8}) {
        if (lane_kernels(lanes) == nullptr) continue;
        EXPECT_EQ(in_lanes(lanes), expected) << lanes << " lanes";
    }
}

TEST_P(SameBits, ForAnySkin) {
    const auto expected = hashes(made({2}));
    for (const double skin : {0.02e-3, 0.2e-3, 1e-3}) {
        Scene scene = made({2});
        scene.run.skin = skin;
        EXPECT_EQ(hashes(std::move(scene)), expected) << "skin " << skin;
    }
}

// Contacts, motions and batches under way at every restart; each with another number of threads.
TEST_P(SameBits, AcrossRestarts) {
    const NamedScene& named = GetParam();
    auto simulation = std::make_unique<Simulation>(made({2}), named.dt);
    std::vector<std::uint64_t> found;
    for (int step = 1; step <= named.steps; ++step) {
        simulation->step();
        if (step % 100 == 0) found.push_back(simulation->state_hash());
        if (step != 1 && step % (named.steps / 5) != 3) continue;
        StateWriter writer;
        simulation->save(writer);
        const Energies before = energies(*simulation);
        simulation = std::make_unique<Simulation>(made({1 + step % 4}), named.dt);
        StateReader reader(writer.take(), "memory");
        simulation->load(reader);
        reader.finish();
        const Energies after = energies(*simulation);
        EXPECT_EQ(before.elastic, after.elastic);
        EXPECT_EQ(before.residual(), after.residual());
    }
    EXPECT_EQ(found, hashes(made({2})));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SameBits,
    testing::Values(NamedScene{"polydisperse_spheres", polydisperse_spheres, 4e-6, 2000},
                    NamedScene{"run_out", spheres_that_run_out, 4e-6, 2000},
                    NamedScene{"batches", batches_into_a_turning_vessel, 6e-6, 4000},
                    NamedScene{"continuous", continuous_mixture, 1e-5, 3000},
                    NamedScene{"tablets", tablets, 5e-6, 4000},
                    NamedScene{"nodes", node_mixture, 1e-5, 3000},
                    NamedScene{"clumps", clump_mixture, 1e-5, 3000},
                    NamedScene{"convex", convex_mixture, 1e-5, 1500},
                    NamedScene{"no_slip", mixture_without_slip, 8e-6, 1000},
                    NamedScene{"motions", motions_after_rest, 2e-5, 9000},
                    NamedScene{"triangles", vessels_of_triangles, 1e-5, 2500}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace dem::runtime
