// SPDX-License-Identifier: BSD-3-Clause
// A body slides down by random steps to lower places, longer ones after each that was free and
// shorter ones after each that was not, until they are a thousandth of its radius: spheres end in
// hollows between others, as those of Visscher and Bolsterli (1972) do by rolling.
#include "runtime/insertion/fill.hpp"

#include "common/error.hpp"
#include "runtime/insertion/body_draw.hpp"
#include "runtime/insertion/region_frame.hpp"
#include "runtime/integrator/rigid_body.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace dem::runtime {

namespace {

constexpr int starts = 5;  // twice as many fill 0.003 more
constexpr int tries_per_start = 2000;
constexpr double longer = 1.5;
constexpr double shorter = 0.93;    // faster, and narrow ways down are missed
constexpr double last_step = 1e-3;  // of the bounding radius

/// Where the bodies of a group may lie.
class Room {
  public:
    Room(const Scene& scene, std::uint32_t group, const Occupancy& occupancy)
        : scene_(scene),
          occupancy_(occupancy),
          frame_(scene.insertions[group].region),
          up_(up_direction(scene)),
          may_turn_(!scene.insertions[group].orientation) {}

    /// A free place and orientation at random; nullopt when none was found.
    std::optional<BodyPlacement> start(BodyDraw& draw) const {
        for (int n = 0; n < tries_per_start; ++n) {
            draw.turn();
            BodyPlacement body = draw.body();
            const auto place = frame_.sample(draw.random(), shape_of(body), body.orientation);
            if (!place) continue;
            body.position = *place;
            if (occupancy_.is_free(body)) return body;
        }
        return std::nullopt;
    }

    BodyPlacement slid_down(BodyPlacement body, Random& random) const {
        const ParticleTemplate& shape = shape_of(body);
        const double radius = shape.bounding_radius;
        const bool turns = may_turn_ && !std::holds_alternative<Sphere>(shape.shape);
        double step = radius;
        while (step > last_step * radius) {
            const Vec3 way = random.direction();
            BodyPlacement next = body;
            next.position += step * (way.dot(up_) > 0.0 ? Vec3(-way) : way);
            if (turns) {
                const Vec3 turn = std::min(1.0, step / radius) * random.direction();
                next.orientation = (rotation(turn) * body.orientation).normalized();
            }
            const bool is_free = frame_.contains(shape, next) && occupancy_.is_free(next);
            if (is_free) body = next;
            step *= is_free ? longer : shorter;
        }
        return body;
    }

    double height(const BodyPlacement& body) const { return body.position.dot(up_); }

  private:
    const ParticleTemplate& shape_of(const BodyPlacement& body) const {
        return scene_.shapes[scene_.kinds[body.kind].shape];
    }

    const Scene& scene_;
    const Occupancy& occupancy_;
    RegionFrame frame_;
    Vec3 up_;
    bool may_turn_;
};

/// The lowest place found for body k of a group; nullopt when there was none.
std::optional<BodyPlacement> lowest_place(const Room& room, BodyDraw draw) {
    std::optional<BodyPlacement> lowest;
    for (int n = 0; n < starts; ++n) {
        const auto start = room.start(draw);
        if (!start) return lowest;
        const BodyPlacement body = room.slid_down(*start, draw.random());
        if (!lowest || room.height(body) < room.height(*lowest)) lowest = body;
    }
    return lowest;
}

}  // namespace

std::vector<BodyPlacement> fill_placements(const Scene& scene, std::uint32_t group_index,
                                           Occupancy& occupancy) {
    const InsertionGroup& group = scene.insertions[group_index];
    const Room room(scene, group_index, occupancy);
    std::vector<BodyPlacement> placed;
    while (placed.size() < group.count) {
        const auto body = lowest_place(room, BodyDraw(scene, group_index, placed.size()));
        if (!body) {
            throw Error(group.where, "the region of [particles." + group.name + "] holds " +
                                         std::to_string(placed.size()) + " of " +
                                         std::to_string(group.count) +
                                         " bodies packed from the bottom, expected a larger region "
                                         "or a smaller count");
        }
        occupancy.add(*body);
        placed.push_back(*body);
    }
    return placed;
}

}  // namespace dem::runtime
