// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/occupancy.hpp"

#include "runtime/contact/pairs/touch.hpp"
#include "runtime/walls/wall_distance.hpp"

namespace dem::runtime {

namespace {

PairState pair_state(const Vec3& displacement, const Quat& i, const Quat& j) {
    PairState pair;
    pair.displacement = displacement;
    pair.i.orientation = i;
    pair.j.orientation = j;
    return pair;
}

}  // namespace

Occupancy::Occupancy(const Scene& scene, const Particles& particles, const Aabb& room, double time)
    : scene_(scene), next_id_(particles.size()) {
    for (const Wall& wall : scene.walls) walls_.push_back(wall_state(wall, time));
    for (std::uint32_t id = 0; id < particles.size(); ++id) {
        BodyPlacement body;
        body.position = particles.position[id];
        body.orientation = particles.orientation[id];
        body.kind = particles.kind[id];
        const Aabb point{body.position, body.position};
        if (overlaps(room, point, shape_of(body).bounding_radius)) add(id, body);
    }
}

void Occupancy::add(std::uint32_t id, const BodyPlacement& body) {
    residents_.push_back({id, body});
    grid_.add(body.position, shape_of(body).bounding_radius);
}

void Occupancy::add(const BodyPlacement& body) {
    add(next_id_, body);
    ++next_id_;
}

std::optional<std::uint32_t> Occupancy::overlapped_body(const BodyPlacement& body) const {
    std::optional<std::uint32_t> found;
    const ParticleTemplate& shape = shape_of(body);
    grid_.any_near(body.position, shape.bounding_radius, [&](std::uint32_t number) {
        const Resident& other = residents_[number];
        const PairState pair = pair_state(body.position - other.body.position,
                                          other.body.orientation, body.orientation);
        if (touches(shape_of(other.body), shape, pair)) found = other.id;
        return found.has_value();
    });
    return found;
}

const Wall* Occupancy::overlapped_wall(const BodyPlacement& body) const {
    const ParticleTemplate& shape = shape_of(body);
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        const Wall& wall = scene_.walls[w];
        if (wall_distance(wall.shape, walls_[w], body.position) >= shape.bounding_radius) continue;
        const PairState pair = pair_state(walls_[w].position - body.position, body.orientation,
                                          walls_[w].body.orientation);
        if (touches(shape, wall.shape, pair)) return &wall;
    }
    return nullptr;
}

}  // namespace dem::runtime
