// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/seen_contacts.hpp"

#include "runtime/contact/law/motion.hpp"

#include <algorithm>
#include <tuple>

namespace dem::runtime {

void note(std::span<const PairContact> contacts, const SeenPair& pair, const Bodies& bodies,
          std::vector<SeenContact>& seen) {
    const auto& [ids, is_wall, begins] = pair;
    const Particles& p = bodies.particles;
    const Vec3 center = p.position[ids.i];
    const PairState state = is_wall ? bodies.wall_pair(ids.i, ids.j) : bodies.pair(ids.i, ids.j);
    for (const PairContact& contact : contacts) {
        const Vec3 point = center + contact.place;
        SeenContact one;
        one.i = p.id[ids.i];
        one.j = is_wall ? ids.j : p.id[ids.j];
        one.is_wall = is_wall ? 1 : 0;
        one.slips = contact.friction.norm() > (1.0 - 1e-9) * contact.friction_limit ? 1 : 0;
        one.begins = begins ? 1 : 0;
        one.center_i = center;
        one.center_j = is_wall ? point : p.position[ids.j];
        one.point = point;
        one.normal = contact.normal;
        one.force = contact.force;
        one.friction = contact.friction;
        one.velocity = relative_velocity(state, contact.place);
        one.normal_force = contact.normal_force;
        one.friction_limit = contact.friction_limit;
        one.overlap = contact.overlap;
        seen.push_back(one);
    }
}

void put_in_order(std::vector<SeenContact>& seen) {
    std::stable_sort(seen.begin(), seen.end(), [](const SeenContact& a, const SeenContact& b) {
        return std::tuple(a.is_wall, a.i, a.j) < std::tuple(b.is_wall, b.i, b.j);
    });
}

void forget_missing(std::span<const std::uint32_t> ids, std::vector<SeenContact>& seen) {
    const auto is_missing = [&](std::uint32_t id) {
        return !std::binary_search(ids.begin(), ids.end(), id);
    };
    std::erase_if(seen, [&](const SeenContact& contact) {
        return is_missing(contact.i) || (contact.is_wall == 0 && is_missing(contact.j));
    });
}

}  // namespace dem::runtime
