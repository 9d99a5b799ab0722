// SPDX-License-Identifier: BSD-3-Clause
#include "tests/runtime/simulation/scenes.hpp"

#include "common/random.hpp"
#include "common/shapes/sdf_quadtree.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"
#include "tests/support/hull_by_force.hpp"

#include <cmath>
#include <utility>

namespace dem::scenes {

using namespace runtime;

namespace {

// Volume and moments per density by summing rings of the cross-section that the distance field
// says are inside: good to 1e-4, enough for tests.
MassProperties mass_properties(const SrShape& shape) {
    MassProperties m;
    const double h = shape.major_axis_length / 400.0;
    const double R = shape.max_radius;
    for (double z = -shape.bounding_radius + 0.5 * h; z < shape.bounding_radius; z += h) {
        for (double r = 0.5 * h; r < R + h; r += h) {
            if (interpolate(shape.sdf, r, z).distance > 0.0) continue;
            const double ring = 2.0 * pi * r * h * h;
            m.volume += ring;
            m.principal_moments_per_density +=
                ring * Vec3(0.5 * r * r + z * z, 0.5 * r * r + z * z, r * r);
        }
    }
    m.principal_moments_per_density.y() = m.principal_moments_per_density.x();
    return m;
}

ParticleTemplate sr_template(const char* name, SrShape shape) {
    ParticleTemplate result;
    result.name = name;
    result.mass_properties = mass_properties(shape);
    result.bounding_radius = shape.bounding_radius;
    result.is_convex = shape.is_convex;
    result.shape = std::move(shape);
    return result;
}

}  // namespace

ParticleTemplate sphere(double radius) {
    ParticleTemplate shape;
    shape.name = "sphere";
    shape.mass_properties.volume = 4.0 / 3.0 * pi * cube(radius);
    shape.mass_properties.principal_moments_per_density =
        Vec3::Constant(0.4 * shape.mass_properties.volume * square(radius));
    shape.bounding_radius = radius;
    shape.mean_squared_surface_distance = square(radius);
    shape.is_convex = true;
    shape.shape = Sphere{radius};
    return shape;
}

ParticleTemplate candy(std::uint32_t nodes) {
    SrShape shape = test::candy(nodes);
    shape.support = test::spheroid(6.585e-3, 3.395e-3).shape.support;
    return sr_template("candy", std::move(shape));
}

ParticleTemplate peanut(std::uint32_t nodes) {
    return sr_template("peanut", test::peanut(nodes));
}

ParticleTemplate tablet() {
    const test::SolidBody solid = test::tablet();
    ParticleTemplate result;
    result.name = "tablet";
    result.mass_properties.volume = solid.volume;
    result.mass_properties.principal_moments_per_density = solid.moments_per_density;
    result.bounding_radius = solid.shape.bounding_radius;
    result.is_convex = true;
    result.shape = solid.shape;
    return result;
}

ParticleTemplate candy_clump(std::uint32_t spheres) {
    const double a = 6.585e-3;
    const double c = 3.395e-3;
    ParticleTemplate result;
    result.name = "candy clump";
    result.mass_properties.volume = 4.0 / 3.0 * pi * a * a * c;
    result.mass_properties.principal_moments_per_density =
        result.mass_properties.volume / 5.0 * Vec3(a * a + c * c, a * a + c * c, 2.0 * a * a);
    result.bounding_radius = a * (1.0 + 1e-9);
    result.shape = test::candy_clump(spheres);
    return result;
}

ParticleTemplate dumbbell_clump() {
    ParticleTemplate result = sphere(2e-3);
    result.name = "dumbbell";
    result.mass_properties.volume *= 2.2;
    const double m = result.mass_properties.volume;
    result.mass_properties.principal_moments_per_density = m * Vec3(1.6e-6, 13e-6, 14e-6);
    result.bounding_radius = 5.5e-3;
    result.is_convex = false;
    result.shape = test::dumbbell_clump(3.5e-3, 2e-3);
    return result;
}

Scene one_material(const Stuff& stuff) {
    Scene scene;
    scene.case_path = "test.ini";
    scene.materials = {{"stuff", stuff.density, stuff.youngs_modulus, 0.3}};
    ContactLaw options = stuff.options;
    options.friction = stuff.friction;
    const Elasticity elasticity{stuff.youngs_modulus, 0.3};
    scene.laws = LawTable(1);
    scene.laws.set(0, 0, pair_law(elasticity, elasticity, stuff.restitution, options));
    scene.run.gravity = {0.0, 0.0, -9.81};
    scene.run.end_time = 1.0;
    return scene;
}

std::uint32_t add_kind(Scene& scene, const ParticleTemplate& shape) {
    scene.shapes.push_back(shape);
    BodyKind kind;
    kind.shape = static_cast<std::uint32_t>(scene.shapes.size() - 1);
    const double density = scene.materials[0].density;
    kind.mass = density * shape.mass_properties.volume;
    kind.inertia = density * shape.mass_properties.principal_moments_per_density;
    kind.inverse_inertia = {1.0 / kind.mass, kind.inertia.cwiseInverse(),
                            shape.mean_squared_surface_distance / kind.inertia.mean()};
    scene.kinds.push_back(kind);
    return static_cast<std::uint32_t>(scene.kinds.size() - 1);
}

ParticleTemplate convex(const ConvexSolid& solid) {
    ParticleTemplate t;
    t.name = "convex";
    t.mass_properties = solid.mass_properties;
    t.bounding_radius = solid.shape.bounding_radius;
    t.mean_squared_surface_distance = solid.mean_squared_surface_distance;
    t.is_convex = true;
    t.shape = solid.shape;
    return t;
}

ParticleTemplate sand_grain(double size, std::uint32_t corners, std::uint64_t seed) {
    Random random(seed, corners);
    std::vector<Vec3> points;
    for (std::uint32_t k = 0; k < corners; ++k)
        points.emplace_back(0.49 * size * random.direction().cwiseProduct(Vec3(1.0, 1.2, 0.8)));
    return convex(with_mass_properties(rounded_around(test::hull_by_force(points), 0.01 * size)));
}

InsertionGroup placed(std::vector<BodyPlacement> placements) {
    InsertionGroup group;
    group.name = "placed";
    group.where = "test.ini:1";
    group.mode = InsertionGroup::Mode::file;
    group.kinds = {0};
    group.count = placements.size();
    group.placements = std::move(placements);
    group.allow_overlaps = true;
    return group;
}

Wall plane(const Vec3& point, const Vec3& normal) {
    Wall wall;
    wall.name = "plane";
    wall.shape = PlaneWall{};
    wall.position = point;
    wall.orientation = orientation_towards(normal);
    return wall;
}

void add_box(Scene& scene, const Vec3& lower, const Vec3& upper) {
    for (int axis = 0; axis < 3; ++axis) {
        scene.walls.push_back(plane(lower, Vec3::Unit(axis)));
        scene.walls.push_back(plane(upper, -Vec3::Unit(axis)));
    }
}

void add_vessel(Scene& scene, double radius) {
    Wall side;
    side.name = "side";
    side.shape = CylinderWall{.radius = radius};
    scene.walls.push_back(side);
    scene.walls.push_back(plane(Vec3::Zero(), Vec3::UnitZ()));
}

std::vector<BodyPlacement> column(std::uint32_t count, std::uint32_t kinds, double radius,
                                  double cell) {
    std::vector<BodyPlacement> bodies;
    const int across = static_cast<int>(radius / cell);
    for (int layer = 0; bodies.size() < count; ++layer) {
        for (int y = -across; y <= across; ++y) {
            for (int x = -across; x <= across && bodies.size() < count; ++x) {
                if (cell * std::hypot(x, y) > radius - 0.5 * cell) continue;
                const auto n = static_cast<std::uint32_t>(bodies.size());
                BodyPlacement body;
                body.kind = n % kinds;
                body.position = cell * Vec3(x, y, layer + 0.5);
                body.orientation = Random(11, n).orientation();
                bodies.push_back(body);
            }
        }
    }
    return bodies;
}

}  // namespace dem::scenes
