// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/inserter.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/insertion/body_draw.hpp"
#include "runtime/insertion/fill.hpp"
#include "runtime/insertion/lattice.hpp"
#include "runtime/insertion/occupancy.hpp"
#include "runtime/insertion/region_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dem::runtime {

namespace {

using Placements = std::vector<BodyPlacement>;

// A body keeps its orientation for many positions before it is turned: bodies that lie favorably
// would otherwise be preferred where it gets crowded.
constexpr int positions_per_turn = 100;
constexpr int turns = 100;

std::optional<BodyPlacement> free_place(const Scene& scene, std::uint32_t group, std::uint64_t k,
                                        const RegionFrame& frame, const Occupancy& occupancy) {
    BodyDraw draw(scene, group, k);
    const ParticleTemplate& shape = scene.shapes[scene.kinds[draw.body().kind].shape];
    for (int turn = 0; turn < turns; ++turn) {
        for (int position = 0; position < positions_per_turn; ++position) {
            const auto sample = frame.sample(draw.random(), shape, draw.body().orientation);
            if (!sample) continue;
            BodyPlacement body = draw.body();
            body.position = *sample;
            if (occupancy.is_free(body)) return body;
        }
        draw.turn();
    }
    return std::nullopt;
}

/// Up to `wanted` bodies from the `first` of the group on, each where the earlier ones left room;
/// ends at the first that finds none.
Placements random_placements(const Scene& scene, std::uint32_t group, std::uint64_t first,
                             std::uint64_t wanted, Occupancy& occupancy) {
    const RegionFrame frame(scene.insertions[group].region);
    Placements placed;
    while (placed.size() < wanted) {
        const auto body = free_place(scene, group, first + placed.size(), frame, occupancy);
        if (!body) break;
        occupancy.add(*body);
        placed.push_back(*body);
    }
    return placed;
}

Placements all_at_once(const Scene& scene, std::uint32_t group_index, Occupancy& occupancy) {
    const InsertionGroup& group = scene.insertions[group_index];
    Placements placed = random_placements(scene, group_index, 0, group.count, occupancy);
    if (placed.size() == group.count) return placed;
    throw Error(group.where, "the region of [particles." + group.name + "] holds " +
                                 std::to_string(placed.size()) + " of " +
                                 std::to_string(group.count) +
                                 " bodies placed at random, expected a larger region, or insert = "
                                 "fill, batches or lattice");
}

/// Throws Error when even the empty region found no place: the batches would wait for ever.
Placements batch(const Scene& scene, std::uint32_t group_index, std::uint64_t first,
                 std::uint64_t wanted, Occupancy& occupancy) {
    const bool was_empty = occupancy.is_empty();
    Placements placed = random_placements(scene, group_index, first, wanted, occupancy);
    const InsertionGroup& group = scene.insertions[group_index];
    if (!placed.empty() || !was_empty) return placed;
    throw Error(group.where, "the region of [particles." + group.name +
                                 "] cannot hold one body, expected a larger region");
}

Placements file_rows(const Scene& scene, std::uint32_t group_index, const Particles& particles,
                     Occupancy& occupancy) {
    const InsertionGroup& group = scene.insertions[group_index];
    if (group.allow_overlaps) return group.placements;
    for (const BodyPlacement& body : group.placements) {
        const std::string row = group.file + ":" + std::to_string(body.line);
        if (const Wall* wall = occupancy.overlapped_wall(body)) {
            throw Error(row, "the body overlaps wall " + in_quotes(wall->name) +
                                 ", expected free places (or 'overlaps = allow')");
        }
        if (const auto other = occupancy.overlapped_body(body)) {
            const std::uint32_t own_first = particles.size();
            const std::string name =
                *other < own_first ? "particle " + std::to_string(particles.id[*other])
                                   : "the body of line " +
                                         std::to_string(group.placements[*other - own_first].line);
            throw Error(row, "the body overlaps " + name +
                                 ", expected free places (or 'overlaps = allow')");
        }
        occupancy.add(body);
    }
    return group.placements;
}

Aabb everywhere() {
    const Vec3 corner = Vec3::Constant(infinite);
    return {-corner, corner};
}

}  // namespace

Inserter::Inserter(const Scene& scene) {
    for (const InsertionGroup& group : scene.insertions) {
        const bool from_file = group.mode == InsertionGroup::Mode::file;
        groups_.push_back(
            {.count = from_file ? group.placements.size() : group.count, .next = group.start});
    }
}

double Inserter::next_time() const {
    double next = std::numeric_limits<double>::infinity();
    for (const Progress& p : groups_) {
        if (p.placed < p.count) next = std::min(next, p.next);
    }
    return next;
}

std::uint64_t Inserter::missing(std::uint32_t group) const {
    return groups_[group].count - groups_[group].placed;
}

std::uint64_t Inserter::crowded_out(std::uint32_t group) const {
    return groups_[group].due - groups_[group].placed;
}

std::uint32_t Inserter::insert_due(const Scene& scene, Particles& particles, double time) {
    const std::uint32_t before = particles.size();
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        if (missing(g) > 0 && groups_[g].next <= time) insert_group(scene, g, particles, time);
    }
    return particles.size() - before;
}

void Inserter::insert_group(const Scene& scene, std::uint32_t g, Particles& particles,
                            double time) {
    using Mode = InsertionGroup::Mode;
    const InsertionGroup& group = scene.insertions[g];
    Progress& progress = groups_[g];
    const Aabb room = group.mode == Mode::file ? everywhere() : bounds(group.region);
    Occupancy occupancy(scene, particles, room, time);
    Placements placed;
    const bool all = group.mode != Mode::batches;
    progress.due = all ? progress.count : std::min(progress.count, progress.due + group.batch);
    switch (group.mode) {
        case Mode::at_once:
            placed = all_at_once(scene, g, occupancy);
            break;
        case Mode::lattice:
            placed = lattice_placements(scene, g, occupancy);
            break;
        case Mode::fill:
            placed = fill_placements(scene, g, occupancy);
            break;
        case Mode::file:
            placed = file_rows(scene, g, particles, occupancy);
            break;
        case Mode::batches:
            placed = batch(scene, g, progress.placed, std::min(group.batch, missing(g)), occupancy);
            // Times are multiples of the interval, never sums; intervals missed are not made up.
            progress.events =
                1 + std::max(progress.events,
                             static_cast<std::uint64_t>((time - group.start) / group.every));
            progress.next = group.start + static_cast<double>(progress.events) * group.every;
            break;
    }
    for (const BodyPlacement& body : placed) {
        particles.append(body.kind, g, body, scene.kinds[body.kind]);
    }
    progress.placed += placed.size();
}

}  // namespace dem::runtime
