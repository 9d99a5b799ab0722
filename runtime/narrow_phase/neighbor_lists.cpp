// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/neighbor_lists.hpp"

#include "common/error.hpp"
#include "common/threads/thread_team.hpp"
#include "runtime/broad_phase/hierarchical_grid.hpp"
#include "runtime/loop_grain.hpp"
#include "runtime/walls/wall_distance.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace dem::runtime {

namespace {

/// Adjacency::Entry has 31 bits for the index of a result.
constexpr std::size_t most_pairs = std::size_t{1} << 31;

bool is_fixed(const BodyKind& kind) {
    return kind.inverse_inertia.mass == 0.0;
}

std::vector<IdPair> pair_candidates(const Bodies& bodies, const BodyAabbs& aabbs,
                                    std::span<const double> margins) {
    const Particles& p = bodies.particles;
    std::vector<Aabb> boxes(p.size());
    share_each(p.size(), bodies_at_a_time, [&](std::size_t i) {
        const std::uint32_t shape = bodies.scene.kinds[p.kind[i]].shape;
        boxes[i] = aabbs.box(shape, p.position[i], p.orientation[i]);
        boxes[i].lower.array() -= margins[i];
        boxes[i].upper.array() += margins[i];
    });
    std::vector<IdPair> pairs = overlapping_pairs(boxes);
    std::erase_if(pairs, [&](const IdPair& pair) {
        return is_fixed(bodies.kind(pair.i)) && is_fixed(bodies.kind(pair.j));
    });
    return pairs;
}

std::vector<IdPair> wall_candidates(const Bodies& bodies, std::span<const double> margins,
                                    std::span<const double> wall_margins) {
    std::vector<IdPair> pairs;
    const auto& walls = bodies.scene.walls;
    for (std::uint32_t i = 0; i < bodies.particles.size(); ++i) {
        if (is_fixed(bodies.kind(i))) continue;
        const double reach = bodies.shape(i).bounding_radius + margins[i];
        for (std::uint32_t w = 0; w < walls.size(); ++w) {
            if (wall_distance(walls[w].shape, bodies.walls.state[w],
                              bodies.particles.position[i]) <= reach + wall_margins[w]) {
                pairs.push_back({i, w});
            }
        }
    }
    return pairs;
}

// Sorts candidates into the lists that handle them; what old pairs remember is kept. Returns the
// index of every candidate's result. `kind_of<List>(pair)`: whether the pair belongs to a list.
template <class... List, class Handles>
std::vector<std::uint32_t> distribute(std::tuple<List...>& lists,
                                      std::span<const IdPair> candidates, const Handles& handles,
                                      std::uint32_t& first_result) {
    constexpr std::size_t kinds = sizeof...(List);
    std::vector<std::uint8_t> kind_of(candidates.size());
    std::array<std::vector<IdPair>, kinds> ids;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        std::uint8_t kind = 0;
        ((handles(static_cast<List*>(nullptr), candidates[c]) || (++kind, false)) || ...);
        DEM_ASSERT(kind < kinds);
        kind_of[c] = kind;
        ids[kind].push_back(candidates[c]);
    }
    std::array<std::uint32_t, kinds> next{};
    std::size_t kind = 0;
    const auto renew = [&](auto& list) {
        const auto old = std::exchange(list, {});
        next[kind] = first_result;
        list.reset(std::move(ids[kind]), first_result);
        carry_over(old, list);
        first_result += list.size();
        ++kind;
    };
    for_each_list(lists, renew);

    std::vector<std::uint32_t> result_of(candidates.size());
    for (std::size_t c = 0; c < candidates.size(); ++c) result_of[c] = next[kind_of[c]]++;
    return result_of;
}

// Candidates are sorted, so filling in this order sorts every particle's partners: first those
// with lower ids (the particle is j), then those with higher ids, then walls.
Adjacency transposed(std::uint32_t particles, std::span<const IdPair> pairs,
                     std::span<const std::uint32_t> pair_result, std::span<const IdPair> walls,
                     std::span<const std::uint32_t> wall_result) {
    Adjacency adjacency;
    adjacency.begin.assign(particles + 1, 0);
    for (const IdPair& pair : pairs) {
        ++adjacency.begin[pair.i + 1];
        ++adjacency.begin[pair.j + 1];
    }
    for (const IdPair& pair : walls) ++adjacency.begin[pair.i + 1];
    for (std::uint32_t i = 0; i < particles; ++i) adjacency.begin[i + 1] += adjacency.begin[i];

    adjacency.entries.resize(adjacency.begin[particles]);
    std::vector<std::uint32_t> next(adjacency.begin.begin(), adjacency.begin.end() - 1);
    const auto add = [&](std::uint32_t particle, std::uint32_t result, bool is_j) {
        adjacency.entries[next[particle]++] = {result & 0x7fffffffU, is_j ? 1U : 0U};
    };
    for (std::size_t c = 0; c < pairs.size(); ++c) add(pairs[c].j, pair_result[c], true);
    for (std::size_t c = 0; c < pairs.size(); ++c) add(pairs[c].i, pair_result[c], false);
    for (std::size_t c = 0; c < walls.size(); ++c) add(walls[c].i, wall_result[c], false);
    return adjacency;
}

}  // namespace

bool is_stale(const NeighborLists& lists, const Bodies& bodies) {
    const Particles& p = bodies.particles;
    if (lists.particle_limit.size() != p.size()) return true;
    if (lists.wall_limit.size() != bodies.walls.travel.size()) return true;
    for (std::size_t w = 0; w < lists.wall_limit.size(); ++w) {
        if (bodies.walls.travel[w] > lists.wall_limit[w]) return true;
    }
    std::atomic<bool> is_any_beyond = false;
    share_loop(p.size(), bodies_at_a_time, [&](const LoopPart& part) {
        bool is_beyond = false;
        for (std::size_t i = part.begin; i < part.end; ++i)
            is_beyond = is_beyond || p.travel[i] > lists.particle_limit[i];
        if (is_beyond) is_any_beyond = true;
    });
    return is_any_beyond;
}

void rebuild(NeighborLists& lists, const Bodies& bodies, const BodyAabbs& aabbs,
             std::span<const double> margins, std::span<const double> wall_margins) {
    const std::vector<IdPair> pairs = pair_candidates(bodies, aabbs, margins);
    const std::vector<IdPair> wall_pairs = wall_candidates(bodies, margins, wall_margins);
    const std::size_t total = pairs.size() + wall_pairs.size();
    if (total >= most_pairs) {
        throw Error(bodies.scene.case_path, "found " + std::to_string(total) +
                                                " candidate pairs, expected at most " +
                                                std::to_string(most_pairs));
    }

    std::uint32_t first_result = 0;
    const auto pair_result = distribute(
        lists.pairs, pairs,
        [&]<class List>(List*, const IdPair& pair) {
            return handles<typename List::Row>(bodies.shape(pair.i), bodies.shape(pair.j),
                                               bodies.law(pair.i, pair.j));
        },
        first_result);
    const auto wall_result = distribute(
        lists.walls, wall_pairs,
        [&]<class List>(List*, const IdPair& pair) {
            return handles<typename List::Row>(bodies.shape(pair.i),
                                               bodies.scene.walls[pair.j].shape,
                                               bodies.wall_law(pair.i, pair.j));
        },
        first_result);
    lists.adjacency =
        transposed(bodies.particles.size(), pairs, pair_result, wall_pairs, wall_result);
    lists.touching_entries.reset(lists.adjacency);

    lists.results.resize(total);
    lists.touching.assign(total, 0);
    lists.particle_limit.resize(bodies.particles.size());
    for (std::uint32_t i = 0; i < bodies.particles.size(); ++i) {
        lists.particle_limit[i] = bodies.particles.travel[i] + margins[i];
    }
    lists.wall_limit = bodies.walls.travel;
    for (std::size_t w = 0; w < wall_margins.size(); ++w) lists.wall_limit[w] += wall_margins[w];
    ++lists.rebuilds;
}

void index_contacts(NeighborLists& lists, std::uint32_t particles) {
    struct Contacts {
        std::vector<IdPair> ids;
        std::vector<std::uint32_t> results;
    };
    // All lists together in the order of ids, as the candidates of a rebuild are.
    const auto collected = [](const auto& some) {
        std::vector<std::pair<IdPair, std::uint32_t>> all;
        for_each_list(some, [&](const auto& list) {
            for (std::uint32_t k = 0; k < list.size(); ++k)
                all.emplace_back(list.ids[k], list.first_result + k);
        });
        std::sort(all.begin(), all.end());
        Contacts contacts;
        for (const auto& [ids, result] : all) {
            contacts.ids.push_back(ids);
            contacts.results.push_back(result);
        }
        return contacts;
    };
    const Contacts pairs = collected(lists.pairs);
    const Contacts walls = collected(lists.walls);
    lists.adjacency = transposed(particles, pairs.ids, pairs.results, walls.ids, walls.results);
    lists.touching_entries.reset(lists.adjacency);
}

}  // namespace dem::runtime
