// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"
#include "tests/physics/bounces/members.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#ifndef RANDOM_SCENES
#define RANDOM_SCENES 10
#define RANDOM_SCENE_STEPS 6000
#define RANDOM_SCENE_DIVISOR 60
#define RANDOM_SCENE_RESIDUAL 1e-3
#endif

// Mixtures of all kinds of shape, sizes up to 1:30, every wall and motion, both laws, restitution
// 0.01 to 1, friction 0 to 3, one seed a scene (docs/reliability.md).
namespace dem::test {

using namespace runtime;
using namespace shapegen;

namespace {

constexpr int kinds_per_scene = 6;
constexpr int bodies_per_kind = 6;
constexpr double solid_share = 0.1;  // random places are still found
constexpr double fastest = 5.0;      // [m/s]

double log_uniform(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

Vec3 random_velocity(Random& random) {
    return fastest * random.uniform() * random.direction();
}

/// Half a millimeter to fifteen, those of other kinds 2 to 5 mm.
ParticleTemplate any_body(Random& random) {
    const double size = log_uniform(random, 0.5e-3, 15e-3);
    switch (static_cast<int>(random.uniform() * 4.0)) {
        case 0:
            return scenes::sphere(size);
        case 1:
            return scenes::convex(make_cuboid(size * Vec3(1.0, 1.6, 2.0), 0.03 * size));
        default: {
            const auto kind = static_cast<std::size_t>(random.uniform() * 9.0);
            // Whatever touches clumps needs its distance field.
            return member(kinds[kind], Kind::clump, random);
        }
    }
}

ContactLaw any_law(Random& random, double modulus, double mass) {
    ContactLaw options;
    if (random.uniform() < 0.5) options.tangential = ContactLaw::Tangential::ratio;
    options.friction = random.uniform() < 0.2 ? 0.0 : random.uniform(0.0, 3.0);
    const double restitution = random.uniform() < 0.2 ? 1.0 : log_uniform(random, 0.01, 1.0);
    const Elasticity elasticity{modulus, 0.3};
    const ContactLaw hertz = pair_law(elasticity, elasticity, restitution, options);
    if (random.uniform() < 0.7) return hertz;
    // An overlap of a tenth of a millimeter where the heaviest meets another at full speed.
    const double stiffness = mass * square(2.0 * fastest / 1e-4);
    return linear_law(stiffness, restitution, random.uniform(0.1, 1.0), hertz);
}

void move(Wall& wall, Random& random) {
    WallMotion& motion = wall.motion;
    switch (static_cast<int>(random.uniform() * 4.0)) {
        case 0:
            motion.kind = WallMotion::Kind::translate;
            motion.velocity = wall.orientation * Vec3(0.0, 0.0, 0.2);  // planes: inwards
            break;
        case 1:
            motion.kind = WallMotion::Kind::rotate;
            motion.axis = wall.orientation * Vec3::UnitZ();
            motion.point = wall.position;
            motion.rate = random.uniform(-50.0, 50.0);
            break;
        case 2:
            motion.kind = WallMotion::Kind::oscillate;
            motion.axis = wall.orientation * Vec3::UnitZ();
            motion.amplitude = 2e-4;
            motion.frequency = random.uniform(50.0, 500.0);
            break;
        default:
            break;
    }
}

void add_groups(Scene& scene, const Region& region, Random& random) {
    for (std::uint32_t kind = 0; kind < scene.kinds.size(); ++kind) {
        InsertionGroup group;
        group.name = "k" + std::to_string(kind);
        group.where = "test.ini:1";
        group.kinds = {kind};
        group.count = bodies_per_kind;
        group.region = region;
        group.velocity = random_velocity(random);
        group.angular_velocity = 100.0 * random.direction();
        scene.insertions.push_back(group);
    }
}

double largest_radius(const Scene& scene) {
    double radius = 0.0;
    for (const ParticleTemplate& t : scene.shapes) radius = std::max(radius, t.bounding_radius);
    return radius;
}

/// Without walls there is no gravity, and the bodies fly apart.
Scene random_scene(std::uint64_t seed, bool has_walls) {
    Random random(2026, seed);
    constexpr double modulus = 1e9;
    Scene scene = scenes::one_material({modulus, 2500.0, 0.5, 0.5});
    double volume = 0.0;
    double heaviest = 0.0;
    for (int k = 0; k < kinds_per_scene; ++k) {
        const std::uint32_t kind = scenes::add_kind(scene, any_body(random));
        volume += bodies_per_kind * scene.shapes[kind].mass_properties.volume;
        heaviest = std::max(heaviest, scene.kinds[kind].mass);
    }
    scene.laws.set(0, 0, any_law(random, modulus, heaviest));
    const double edge = std::max(std::cbrt(volume / solid_share), 6.0 * largest_radius(scene));
    const Vec3 upper(edge, edge, edge);
    Region region = BoxRegion{{Vec3::Zero(), upper}};
    if (!has_walls) {
        scene.run.gravity = Vec3::Zero();
        scene.run.domain = Aabb{Vec3::Constant(-10.0), Vec3::Constant(10.0)};
    } else if (random.uniform() < 0.5) {
        scenes::add_box(scene, Vec3::Zero(), upper);
    } else {
        scenes::add_vessel(scene, 0.5 * edge);
        scene.walls.push_back(scenes::plane(upper, -Vec3::UnitZ()));
        region = CylinderRegion{Vec3::Zero(), {0.0, 0.0, edge}, 0.5 * edge};
    }
    for (Wall& wall : scene.walls) move(wall, random);
    if (has_walls && random.uniform() < 0.5) {
        Wall rod;
        rod.name = "rod";
        rod.shape = CylinderWall{.radius = 0.05 * edge, .length = 0.3 * edge, .inside = false};
        rod.position = region.index() == 0 ? Vec3(0.5 * edge, 0.5 * edge, 0.0) : Vec3::Zero();
        scene.walls.push_back(rod);
    }
    add_groups(scene, region, random);
    scene.run.seed = seed;
    scene.run.time_step_divisor = RANDOM_SCENE_DIVISOR;
    scene.run.overlap_limit = 0.6;  // the smallest are crushed between the largest
    return scene;
}

/// Energy that there is to lose: kinetic at the start, that of a fall by the largest radius, and
/// the work of walls [J].
double scale_of(const Simulation& simulation, double kinetic) {
    const Scene& scene = simulation.scene();
    double fall = 0.0;
    for (const BodyKind& kind : scene.kinds)
        fall += bodies_per_kind * kind.mass * scene.run.gravity.norm() * largest_radius(scene);
    return kinetic + fall + std::abs(energies(simulation).wall_work);
}

double kinetic_energy(const Simulation& simulation) {
    const Energies e = energies(simulation);
    return e.translational + e.rotational;
}

/// Momentum and, about the origin, angular momentum.
std::pair<Vec3, Vec3> momenta(const Simulation& simulation) {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 momentum = simulation.scene().kinds[p.kind[i]].mass * p.velocity[i];
        linear += momentum;
        angular += p.position[i].cross(momentum) + p.angular_momentum[i];
    }
    return {linear, angular};
}

/// Steps a scene to its end; calls look(simulation) now and then.
template <class Look>
void run(Scene scene, const Look& look) {
    const double dt = time_step(scene).value;
    Simulation simulation(std::move(scene), dt);
    for (int step = 0; step < RANDOM_SCENE_STEPS; ++step) {
        simulation.step();
        if (step % 20 == 0) look(simulation);
    }
}

TEST(RandomScenes, KeepTheirEnergyLedgerAndTheirBodies) {
    int touched = 0;
    int crushed = 0;
    for (std::uint64_t seed = 0; seed < RANDOM_SCENES; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        bool has_touched = false;
        bool cores_met = false;  // what then happens is no potential (docs/contact-convex.md)
        double kinetic = -1.0;
        double worst = 0.0;
        try {
            run(random_scene(seed, true), [&](const Simulation& simulation) {
                if (kinetic < 0.0) kinetic = kinetic_energy(simulation);
                const Energies e = energies(simulation);
                const double share = std::abs(e.residual()) / scale_of(simulation, kinetic);
                worst = std::max(worst, share);
                cores_met = simulation.core_overlaps() > 0;
                has_touched = has_touched || e.dissipated > 0.0 || e.elastic > 0.0;
                ASSERT_EQ(simulation.particles().size(), kinds_per_scene * bodies_per_kind);
            });
        } catch (const Error& error) {
            // Up to then the ledger must have closed all the same.
            const std::string reason = error.what();
            if (reason.find(" overlap by ") == std::string::npos) ADD_FAILURE() << reason;
            ++crushed;
        }
        EXPECT_LT(worst, cores_met ? 0.1 : RANDOM_SCENE_RESIDUAL);
        touched += has_touched ? 1 : 0;
    }
    EXPECT_GT(touched, RANDOM_SCENES / 2);
    EXPECT_LE(crushed, RANDOM_SCENES / 200);  // seed 102
}

TEST(RandomScenes, KeepTheirMomentumInFreeSpace) {
    for (std::uint64_t seed = 0; seed < RANDOM_SCENES; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::optional<std::pair<Vec3, Vec3>> before;
        double size = 0.0;
        run(random_scene(seed, false), [&](const Simulation& simulation) {
            const auto now = momenta(simulation);
            if (!before) {
                before = now;
                size = now.second.norm() + largest_radius(simulation.scene()) * now.first.norm();
            }
            EXPECT_LT((now.first - before->first).norm(), 1e-11 * now.first.norm());
            EXPECT_LT((now.second - before->second).norm(), 1e-6 * size);
        });
    }
}

}  // namespace
}  // namespace dem::test
