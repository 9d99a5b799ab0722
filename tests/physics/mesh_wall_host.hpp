// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/ball_mesh.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/memory_of.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"
#include "tests/support/sample_walls.hpp"

#include <cmath>
#include <memory>
#include <utility>

/// Bodies that touch walls of triangles, and planes in the same place.
namespace dem::test::mesh_walls {

using namespace runtime;

inline const Elasticity rubber{5e7, 0.29};
inline constexpr double radius = 5e-3;

inline MeshWall mesh_wall(const sample::Surface& surface) {
    return {std::make_shared<const WallMesh>(surface.wall())};
}

inline ContactLaw rough_law() {
    ContactLaw options;
    options.friction = 0.3;
    return pair_law(rubber, rubber, 0.6, options);
}
inline ContactLaw elastic_law() {
    return pair_law(rubber, rubber, 1.0);
}

/// What the host owns for a body and a mesh wall.
template <class Shape>
struct MeshHost {
    Shape shape;
    MeshWall wall;
    MeshHistory history{};
    NearCache cache{};
    ContactScratch scratch = ContactScratch(4000);
    double travel = 0.0;

    PairContact operator()(const PairState& pair, const ContactLaw& law, double dt) {
        // No point of these bodies is farther from the center than 1.5 radii.
        travel +=
            1.01 * dt * (pair.i.velocity.norm() + 1.5 * radius * pair.i.angular_velocity.norm()) +
            1e-15;
        if (history.used == 0 && travel < cache.clear_until) return {};
        const MeshCall call{pair, law, dt, {history, cache}, travel, {&scratch}};
        return collide(shape, wall, call);
    }
};

/// A plane at a place, and what a sphere remembers of it.
struct PlaneHost {
    Vec3 origin;
    Vec3 normal;
    PointHistory history{};

    PairContact operator()(const PairState& pair, const ContactLaw& law, double dt) {
        PairState placed = pair;
        placed.displacement += origin;
        placed.j.orientation = orientation_towards(normal);
        return collide(Sphere{radius}, PlaneWall{}, Call{placed, law, dt, memory_of(history)});
    }
};

inline PairContact sum(const PairContact& a, const PairContact& b) {
    PairContact c = a;
    c.force += b.force;
    c.torque_i += b.torque_i;
    c.elastic_energy += b.elastic_energy;
    c.dissipated_energy += b.dissipated_energy;
    c.points += b.points;
    return c;
}

inline TwoBodies thrown(Random& random, const Vec3& towards, double distance) {
    TwoBodies bodies;
    bodies.i.inverse = solid_sphere(1377.0, radius);
    bodies.i.position = -distance * towards;
    bodies.i.velocity = random.uniform(0.1, 0.5) * (towards + 0.6 * random.direction());
    bodies.i.angular_momentum =
        random.uniform(0.0, 40.0) / bodies.i.inverse.moments.x() * random.direction();
    return bodies;
}

inline double difference(const TwoBodies& a, const TwoBodies& b) {
    return (a.i.position - b.i.position).norm();
}

inline InverseInertia candy_inertia() {
    const double a2 = square(6.585e-3);
    const double c2 = square(3.395e-3);
    const double mass = 1377.0 * 4.0 / 3.0 * pi * a2 * std::sqrt(c2);
    return inverse_inertia(mass, mass / 5.0 * Vec3(a2 + c2, a2 + c2, 2.0 * a2));
}

/// Force on a sphere at rest at each of many places along a line.
template <class Visit>
void along(const MeshWall& wall, const Vec3& from, const Vec3& to, int steps, const Visit& visit) {
    MeshHost<Sphere> host{{radius}, wall};
    const ContactLaw law = elastic_law();
    for (int n = 0; n <= steps; ++n) {
        PairState pair{};
        pair.displacement = -(from + (to - from) * n / steps);
        pair.i.inverse_inertia = solid_sphere(1377.0, radius);
        host.travel += (to - from).norm() / steps;
        visit(host(pair, law, 1e-6));
    }
}

}  // namespace dem::test::mesh_walls
