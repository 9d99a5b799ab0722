// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"
#include "shapegen/solids/make_convex.hpp"

#include <vector>

/// Scenes built in code for tests and benchmarks.
namespace dem::scenes {

using namespace runtime;
using namespace shapegen;

ParticleTemplate sphere(double radius);
/// The candy of [SR] Sec. 4 and a waisted, non-convex body, with nodes; the candy with a support
/// map, too.
ParticleTemplate candy(std::uint32_t nodes = 2000);
ParticleTemplate peanut(std::uint32_t nodes = 2000);

/// The tablet of [SR] Table 1, with sharp edges: a support map, no nodes.
ParticleTemplate tablet();

/// The candy as a clump of balls that touch it from inside, and two balls with a third between.
ParticleTemplate candy_clump(std::uint32_t spheres = 60);
ParticleTemplate dumbbell_clump();

/// A template of a convex shape.
ParticleTemplate convex(const ConvexSolid& solid);
/// A grain of sand: a rounded polyhedron of random corners on an ellipsoid, about `size` across.
ParticleTemplate sand_grain(double size, std::uint32_t corners, std::uint64_t seed);

struct Stuff {
    double youngs_modulus, density, restitution, friction;
    ContactLaw options = {};
};
/// An empty scene of one material, number 0, in gravity along -z.
Scene one_material(const Stuff& stuff);

/// Adds a shape and the kind of body that it makes of material 0; returns the kind.
std::uint32_t add_kind(Scene& scene, const ParticleTemplate& shape);

/// A group of bodies given one by one. They may overlap: the tests know what they do.
InsertionGroup placed(std::vector<BodyPlacement> placements);

/// A plane through `point` whose solid side is against `normal`.
Wall plane(const Vec3& point, const Vec3& normal);
/// Six planes that look inwards.
void add_box(Scene& scene, const Vec3& lower, const Vec3& upper);
/// A vertical cylinder that keeps bodies inside, with a floor at z = 0.
void add_vessel(Scene& scene, double radius);

/// Bodies of kinds 0, 1, ... in turn at random orientations on a lattice of spacing `cell` in a
/// cylinder of `radius` about z, from z = cell/2 upwards.
std::vector<BodyPlacement> column(std::uint32_t count, std::uint32_t kinds, double radius,
                                  double cell);

}  // namespace dem::scenes
