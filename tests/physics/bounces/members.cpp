// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/bounces/members.hpp"

#include "common/error.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/log_uniform.hpp"
#include "tests/support/sample_convex.hpp"

#include <cmath>

namespace dem::test {

using namespace runtime;

namespace {

double aspect(Random& random) {
    return log_uniform(random, 0.3, 3.0);
}
std::size_t choice(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

ParticleTemplate revolved_template(const SolidBody& solid) {
    ParticleTemplate t;
    t.name = "sr";
    t.mass_properties.volume = solid.volume;
    t.mass_properties.principal_moments_per_density = solid.moments_per_density;
    t.bounding_radius = solid.shape.bounding_radius;
    t.mean_squared_surface_distance = 0.5 * square(t.bounding_radius);
    t.is_convex = solid.shape.is_convex;
    t.shape = solid.shape;
    return t;
}

/// Moments of the enclosing spheroid: energy is kept whatever they are.
ParticleTemplate by_nodes(SrShape shape) {
    SolidBody solid;
    solid.volume = pi / 6.0 * cube(shape.equivalent_diameter);
    const double a2 = square(shape.max_radius);
    const double c2 = square(0.5 * (shape.top_z - shape.bottom_z));
    solid.moments_per_density = solid.volume / 5.0 * Vec3(a2 + c2, a2 + c2, 2.0 * a2);
    shape.is_convex = false;
    solid.shape = std::move(shape);
    return revolved_template(solid);
}

/// A cylinder with half spheres at its ends.
SolidBody spherocylinder(double radius, double height) {
    const double half = 0.5 * height;
    const double sine = 2e-4;
    const double turn = sine / (std::sqrt(1.0 - square(sine)) + sine);
    const double band = half / sine;
    SolidBody solid = cylinder(radius, height + 1.2 * radius);  // mass is not to the point
    SrShape& s = solid.shape;
    s.support = support_map({{0.0, -half, radius, radius},
                             {radius - std::sqrt(square(band) - square(half)), 0.0, band, band},
                             {0.0, half, radius, radius}},
                            {-turn, turn, 1.0});
    s.bottom_z = -half - radius;
    s.top_z = half + radius;
    s.bounding_radius = half + radius;
    s.major_axis_length = 2.0 * (half + radius);
    return solid;
}

SolidBody smooth(double size, Random& random) {
    const double ratio = aspect(random);
    if (choice(random, 2) == 0)
        return spheroid(size / std::cbrt(ratio), size * std::cbrt(square(ratio)));
    return spherocylinder(size / std::cbrt(ratio), size * std::cbrt(ratio));
}

SolidBody sharp(double size, Random& random) {
    const double ratio = aspect(random);
    const double r = size / std::cbrt(ratio);
    const double h = 2.0 * r * ratio;
    const double share = random.uniform(0.15, 0.85);
    switch (choice(random, 4)) {
        case 0:
            return cylinder(r, h);
        case 1:
            return tablet(r, share * h, std::min(0.5 * (1.0 - share) * h, 0.9 * r));
        case 2:
            return frustum(r, share * r, h);
        default:
            return revolved({{0.0, 0.0}, {r, share * h}, {0.0, h}});
    }
}

ParticleTemplate polyhedron(double size, Random& random) {
    const double rounding = size * random.uniform(0.01, 0.04);
    const std::size_t which = choice(random, 4);
    if (which == 0) {
        const Vec3 edges(aspect(random), aspect(random), 1.0);
        return scenes::convex(make_cuboid(1.6 * size / std::cbrt(edges.prod()) * edges, rounding));
    }
    if (which == 1) return scenes::convex(rounded_hull(tetrahedron_corners(2.4 * size), rounding));
    for (;;) {
        const Vec3 axes = size * Vec3(1.0, random.uniform(0.5, 1.0), random.uniform(0.5, 1.2));
        const auto points = random_points(6 + choice(random, 20), axes, random.next());
        try {
            return scenes::convex(rounded_hull(points, rounding));
        } catch (const Error&) {
            continue;  // too thin for the rounding
        }
    }
}

ParticleTemplate with_field(Kind kind) {
    SolidBody solid = kind == Kind::smooth ? spheroid(6.585e-3, 3.395e-3) : tablet();
    SrShape shape = kind == Kind::smooth ? candy(2000) : sharp_tablet();
    shape.support = solid.shape.support;
    solid.shape = std::move(shape);
    return revolved_template(solid);
}

}  // namespace

const char* name(Kind kind) {
    constexpr std::array names = {"sphere",     "smooth",   "sharp", "nodes", "clump", "ellipsoid",
                                  "polyhedron", "cylinder", "cone",  "plane", "tube",  "rod"};
    return names[static_cast<std::size_t>(kind)];
}

ParticleTemplate member(Kind kind, Kind partner, Random& random) {
    static const ParticleTemplate smooth_with_field = with_field(Kind::smooth);
    static const ParticleTemplate sharp_with_field = with_field(Kind::sharp);

    static const std::array<ParticleTemplate, 4> all_nodes = {
        by_nodes(candy(2000)), by_nodes(sharp_tablet()), by_nodes(peanut()),
        by_nodes(red_blood_cell())};
    static const std::array<ParticleTemplate, 3> all_clumps = {
        scenes::candy_clump(20), scenes::candy_clump(100), scenes::dumbbell_clump()};
    const double size = random.uniform(2e-3, 5e-3);
    const double ratio = aspect(random);
    const double r = size / std::cbrt(ratio);
    const double rounding = size * random.uniform(0.01, 0.04);
    switch (kind) {
        case Kind::sphere:
            return scenes::sphere(size);
        case Kind::smooth:
            if (partner == Kind::clump) return smooth_with_field;
            return revolved_template(smooth(size, random));
        case Kind::sharp:
            if (partner == Kind::clump) return sharp_with_field;
            return revolved_template(sharp(size, random));
        case Kind::nodes:
            return all_nodes[choice(random, all_nodes.size())];
        case Kind::clump:
            return all_clumps[choice(random, all_clumps.size())];
        case Kind::ellipsoid:
            return scenes::convex(
                make_ellipsoid(size * Vec3(aspect(random), random.uniform(0.5, 1.5), 1.0)));
        case Kind::polyhedron:
            return polyhedron(size, random);
        case Kind::cylinder:
            return scenes::convex(make_cylinder(r, 2.0 * r * ratio, rounding));
        default:
            return scenes::convex(make_cone(r, 2.0 * r * ratio, rounding));
    }
}

}  // namespace dem::test
