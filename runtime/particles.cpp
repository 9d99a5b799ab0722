// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/particles.hpp"

#include "runtime/compact.hpp"

namespace dem::runtime {

void Particles::append(std::uint32_t kind_index, std::uint32_t group_index,
                       const BodyPlacement& placement, const BodyKind& body_kind) {
    const Quat q = placement.orientation.normalized();
    const Vec3 spin_body = q.conjugate() * placement.angular_velocity;
    id.push_back(next_id++);
    position.push_back(placement.position);
    orientation.push_back(q);
    velocity.push_back(placement.velocity);
    angular_momentum.push_back(q * Vec3(body_kind.inertia.cwiseProduct(spin_body)));
    angular_velocity.push_back(placement.angular_velocity);
    for (auto* array : {&force, &torque, &old_force, &old_torque}) array->push_back(Vec3::Zero());
    kind.push_back(kind_index);
    group.push_back(group_index);
    travel.push_back(0.0);
}

void Particles::remove(std::span<const std::uint8_t> leaving) {
    for (auto* array : {&id, &kind, &group}) compact(*array, leaving);
    for (auto* array : {&position, &velocity, &angular_momentum, &angular_velocity, &force, &torque,
                        &old_force, &old_torque})
        compact(*array, leaving);
    compact(orientation, leaving);
    compact(travel, leaving);
}

}  // namespace dem::runtime
