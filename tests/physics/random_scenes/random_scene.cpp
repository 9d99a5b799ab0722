// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/random_scenes/random_scene.hpp"

#include "runtime/contact/law/pair_law.hpp"
#include "tests/physics/bounces/members.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/log_uniform.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace dem::test {

using namespace runtime;
using namespace shapegen;

namespace {

constexpr double solid_share = 0.1;  // random places are still found

/// Spheres and cuboids of a size up to so much, those of other kinds 2 to 5 mm.
ParticleTemplate any_body(Random& random, double smallest, double largest) {
    const double size = log_uniform(random, smallest, largest);
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
    MotionPiece motion;
    switch (static_cast<int>(random.uniform() * 4.0)) {
        case 0:
            motion.kind = MotionPiece::Kind::translate;
            motion.velocity = wall.orientation * Vec3(0.0, 0.0, 0.2);  // planes: inwards
            break;
        case 1:
            motion.kind = MotionPiece::Kind::rotate;
            motion.axis = wall.orientation * Vec3::UnitZ();
            motion.point = wall.position;
            motion.rate = random.uniform(-50.0, 50.0);
            break;
        case 2:
            motion.kind = MotionPiece::Kind::oscillate;
            motion.axis = wall.orientation * Vec3::UnitZ();
            motion.amplitude = 2e-4;
            motion.frequency = random.uniform(50.0, 500.0);
            break;
        default:
            return;
    }
    wall.motion.pieces = {motion};
}

void add_groups(Scene& scene, const Region& region, double speed, Random& random) {
    for (std::uint32_t kind = 0; kind < scene.kinds.size(); ++kind) {
        InsertionGroup group;
        group.name = "k" + std::to_string(kind);
        group.where = "test.ini:1";
        group.kinds = {kind};
        group.count = bodies_per_kind;
        group.region = region;
        group.velocity = speed * random.uniform() * random.direction();
        group.angular_velocity = 100.0 * random.direction();
        scene.insertions.push_back(group);
    }
}

}  // namespace

double largest_radius(const Scene& scene) {
    double radius = 0.0;
    for (const ParticleTemplate& t : scene.shapes) radius = std::max(radius, t.bounding_radius);
    return radius;
}

namespace {

/// Adds the bodies of a scene; returns the mass of the heaviest and the volume of all.
struct Added {
    double volume = 0.0;    ///< of all bodies [m^3]
    double heaviest = 0.0;  ///< [kg]
};
Added add_kinds(Scene& scene, double smallest, double largest, Random& random) {
    Added added;
    for (int k = 0; k < kinds_per_scene; ++k) {
        const std::uint32_t kind = scenes::add_kind(scene, any_body(random, smallest, largest));
        added.volume += bodies_per_kind * scene.shapes[kind].mass_properties.volume;
        added.heaviest = std::max(added.heaviest, scene.kinds[kind].mass);
    }
    return added;
}

/// A box or a vessel with a lid around the origin or from it on.
Region add_walls(Scene& scene, double edge, Random& random) {
    const Vec3 upper(edge, edge, edge);
    if (random.uniform() < 0.5) {
        scenes::add_box(scene, Vec3::Zero(), upper);
        return BoxRegion{{Vec3::Zero(), upper}};
    }
    scenes::add_vessel(scene, 0.5 * edge);
    scene.walls.push_back(scenes::plane(upper, -Vec3::UnitZ()));
    return CylinderRegion{Vec3::Zero(), {0.0, 0.0, edge}, 0.5 * edge};
}

void add_rod(Scene& scene, const Region& region, double edge) {
    Wall rod;
    rod.name = "rod";
    rod.shape = CylinderWall{.radius = 0.05 * edge, .length = 0.3 * edge, .inside = false};
    rod.position = region.index() == 0 ? Vec3(0.5 * edge, 0.5 * edge, 0.0) : Vec3::Zero();
    scene.walls.push_back(rod);
}

double edge_for(const Scene& scene, double volume) {
    return std::max(std::cbrt(volume / solid_share), 6.0 * largest_radius(scene));
}

}  // namespace

Scene random_scene(std::uint64_t seed, bool has_walls) {
    Random random(2026, seed);
    constexpr double modulus = 1e9;
    Scene scene = scenes::one_material({modulus, 2500.0, 0.5, 0.5});
    const Added bodies = add_kinds(scene, 0.5e-3, 15e-3, random);
    scene.laws.set(0, 0, any_law(random, modulus, bodies.heaviest));
    const double edge = edge_for(scene, bodies.volume);
    Region region = BoxRegion{{Vec3::Zero(), Vec3::Constant(edge)}};
    if (has_walls) {
        region = add_walls(scene, edge, random);
    } else {
        scene.run.gravity = Vec3::Zero();
        scene.run.domain = Aabb{Vec3::Constant(-10.0), Vec3::Constant(10.0)};
    }
    for (Wall& wall : scene.walls) move(wall, random);
    if (has_walls && random.uniform() < 0.5) add_rod(scene, region, edge);
    add_groups(scene, region, fastest, random);
    scene.run.seed = seed;
    scene.run.overlap_limit = 0.6;  // the smallest are crushed between the largest
    return scene;
}

Scene resting_scene(std::uint64_t seed) {
    Random random(2027, seed);
    constexpr double modulus = 2e6;  // long steps
    Scene scene = scenes::one_material({modulus, 2500.0, 0.5, 0.5});
    const Added bodies = add_kinds(scene, 1e-3, 6e-3, random);
    ContactLaw options;
    options.friction = random.uniform(0.3, 3.0);
    options.rolling = {RollingResistance::Model::elastic_plastic, 0.3, 0.3};
    const Elasticity elasticity{modulus, 0.3};
    scene.laws.set(0, 0, pair_law(elasticity, elasticity, random.uniform(0.1, 0.8), options));
    const double edge = edge_for(scene, bodies.volume);
    const Region region = add_walls(scene, edge, random);
    if (random.uniform() < 0.5) add_rod(scene, region, edge);
    add_groups(scene, region, 0.06 * fastest, random);
    scene.run.seed = seed;
    scene.run.overlap_limit = 0.6;
    return scene;
}

}  // namespace dem::test
