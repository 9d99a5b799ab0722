// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_mesh.hpp"

#include "runtime/contact/meshes/mesh_contacts.hpp"
#include "runtime/contact/meshes/near_triangles.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"

#include <algorithm>
#include <array>

namespace dem::runtime {

PairContact collide(const SrShape& a, const MeshWall& wall, const MeshCall& call) {
    const PairState& pair = call.pair;
    std::array<ContactPoint, MeshTouches::capacity> room;  // NOLINT: filled as far as it is used
    MeshContacts contacts(wall, call, room);
    const Mat3 to_mesh = contacts.frame().to_world.transpose();
    const Vec3 axis = body_axis(pair.i.orientation);
    const SmoothBody body{
        contacts.frame().in_mesh(Vec3::Zero()), to_mesh * axis, a.bounding_radius,
        to_mesh * (call.dt * (pair.i.angular_velocity - pair.j.angular_velocity))};
    const SrSupport support{a.support, body.axis};
    const NearTriangles near(*wall.mesh, body.center, body.radius, call);
    const double nearest = contacts.add(support, body, near);
    if (contacts.empty()) {
        const double touching =
            (MeshTouches::touching_reach(*wall.mesh) + sphere_rounding) * body.radius;
        return apart(call, std::min(nearest, near.others()) - touching);
    }
    const SrSupport in_world{a.support, axis};
    return contacts.force([&](std::uint32_t /*ball*/, const Vec3& normal) {
        return contact_radius(call.law, in_world(-normal), a.equivalent_diameter);
    });
}

}  // namespace dem::runtime
