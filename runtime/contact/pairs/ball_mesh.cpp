// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/ball_mesh.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/meshes/mesh_contacts.hpp"
#include "runtime/contact/meshes/near_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

/// The spheres of a clump and their gaps to a surface, for the search of touching ones
/// (clump_search.hpp).
struct SpheresAtMesh {
    struct Sample {
        double distance;  ///< gap to where the smooth surface of hollow edges may be [m]
    };

    const PlacedSpheres& spheres;
    const WallMesh& mesh;
    const MeshFrame& frame;
    double rounding;  ///< [m]

    double distance_of(const Vec3& x, double most) const {
        return distance_within(mesh, frame.in_mesh(x), most);
    }
    /// Gaps beyond a radius are not told apart.
    Sample sample(std::uint32_t k) const {
        const double reach = BallTouches::touching_reach(mesh) * spheres.radius(k);
        return {distance_of(spheres.center(k), 2.0 * reach) - reach};
    }
    static bool accepts(std::uint32_t /*k*/, const Sample& /*sample*/) { return true; }
    double proven_gap(double distance) const { return distance - rounding; }

    template <class Visit>
    double visit_near(double margin, const Visit& visit) const {
        double others = std::numeric_limits<double>::infinity();
        spheres.visit(
            [&](const Clump::Ball& ball) {
                const double reach =
                    BallTouches::touching_reach(mesh) * ball.radius + margin + rounding;
                const double distance = distance_of(spheres.place(ball.center()), 2.0 * reach);
                if (distance < reach) return false;
                others = std::min(others, distance - reach + margin + rounding);
                return true;
            },
            [&](std::uint32_t k) {
                const double reach = BallTouches::touching_reach(mesh) * spheres.radius(k);
                const Sample s{distance_of(spheres.center(k), 2.0 * (reach + margin)) - reach};
                if (s.distance < margin)
                    visit(k, s);
                else
                    others = std::min(others, s.distance);
            });
        return others;
    }
};

}  // namespace

PairContact collide(const Sphere& a, const MeshWall& wall, const MeshCall& call) {
    std::array<ContactPoint, BallTouches::capacity> room;  // NOLINT: filled as far as it is used
    MeshContacts contacts(wall, call, room);
    const BodyBall ball{0, Vec3::Zero(), a.radius};
    const NearTriangles near(*wall.mesh, contacts.frame().in_mesh(ball.center), a.radius, call);
    const double nearest = contacts.add(ball, near);
    if (contacts.empty()) {
        const double touching =
            (BallTouches::touching_reach(*wall.mesh) + sphere_rounding) * a.radius;
        return apart(call, std::min(nearest, near.others()) - touching);
    }
    return contacts.force([&](std::uint32_t /*ball*/, const Vec3& /*normal*/) { return a.radius; });
}

PairContact collide(const Clump& a, const MeshWall& wall, const MeshCall& call) {
    const PlacedSpheres spheres(a, call.pair.i.orientation, Vec3::Zero());
    const double radius = spheres.bound().radius;
    const double rounding = clump_rounding(radius);
    MeshContacts contacts(wall, call, *call.scratch.points);
    const MeshFrame& frame = contacts.frame();
    const SpheresAtMesh elements{spheres, *wall.mesh, frame, rounding};
    visit_touching(elements, list_margin(radius), call.travel, call.memory.cache,
                   [&](std::uint32_t k, const SpheresAtMesh::Sample& /*sample*/) {
                       const BodyBall ball{k, spheres.center(k), spheres.radius(k)};
                       contacts.add(ball, [&](const auto& visit) {
                           visit_near_triangles(*wall.mesh, frame.in_mesh(ball.center),
                                                BallTouches::reach(*wall.mesh) * ball.radius,
                                                visit);
                       });
                   });
    if (contacts.empty()) return parting(call.memory.history);
    return contacts.force(
        [&](std::uint32_t k, const Vec3& /*normal*/) { return spheres.radius(k); });
}

}  // namespace dem::runtime
